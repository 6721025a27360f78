#pragma once
/// Which faces of cracks burn.

#include "transfer/FacePoints.hpp"

#include <limits>

namespace Rhegma::combustion
{

/// What lights the faces of one crack from a time on: a flame that fills a box (of no size: a point) and
/// spreads from there, or the temperature of a face.
template <int D>
struct Ignition
{
  double time = 0.0;                                            ///< nothing burns before it [s]
  bool everywhere = true;                                       ///< all faces at that time
  bool inBox = false;                                           ///< those in a box at that time
  Vector<D> lower{}, upper{};                                   ///< corners of the box [m]
  double flameSpeed = 0.0;                                      ///< with which it spreads [m/s]
  double temperature = std::numeric_limits<double>::infinity(); ///< at which a face ignites [K]

  bool byTemperature() const { return temperature < std::numeric_limits<double>::infinity(); }
  /// Distance of a position from the box [m].
  KOKKOS_INLINE_FUNCTION double distance(const Vector<D>& x) const
  {
    double square = 0.0;
    for (int d = 0; d < D; ++d)
    {
      const double out = x[d] < lower[d] ? lower[d] - x[d] : x[d] > upper[d] ? x[d] - upper[d] : 0.0;
      square += out * out;
    }
    return std::sqrt(square);
  }
};

/// Which face points are lit. A lit point stays lit, wherever its body moves; both faces of a point burn
/// together.
template <int D>
class Fire
{
public:
  /// Updates the marks after face points may have been replaced.
  void update(const FacePoints<D>& points, bool anew);

  /// Lights points of a crack. \param temperature of the faces at each point, below and above [K]; empty
  /// where no particle has heat
  void spread(const State<D>& state, const FacePoints<D>& points, int crack, const Ignition<D>& ignition,
              const View<double* [2]>& temperature) const;

  const View<int*>& lit() const { return lit_; } ///< not 0 where a point burns

  void serialize(Archive& archive);

private:
  View<int*> lit_;
};

} // namespace Rhegma::combustion
