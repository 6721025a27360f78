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
  double time = 0.0;          ///< nothing burns before it [s]
  bool everywhere = true;     ///< all faces at that time
  bool inBox = false;         ///< those in a box at that time
  Vector<D> lower{}, upper{}; ///< corners of the box [m]
  double flameSpeed = 0.0;    ///< with which it spreads at speedPressure [m/s]
  double speedPressure = 1e5; ///< [Pa]
  double speedExponent = 0.0; ///< of the pressure in the speed
  double temperature = std::numeric_limits<double>::infinity(); ///< at which a face ignites [K]

  bool byTemperature() const { return temperature < std::numeric_limits<double>::infinity(); }
  /// Speed of the flame at a pressure [m/s].
  double speedAt(double pressure) const
  {
    return speedExponent > 0.0 ? flameSpeed * std::pow(pressure / speedPressure, speedExponent) : flameSpeed;
  }
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

/// Where faces are too close for the flame: it burns between faces that are open by more than sqrt(C / p^n)
/// (Belyaev et al., Transition from deflagration to detonation in condensed phases, 1975).
struct Quenching
{
  double coefficient = 0.0; ///< C [m2 Pa^n]; 0: it burns at any opening
  double exponent = 0.0;    ///< n

  KOKKOS_INLINE_FUNCTION bool quenches(double opening, double pressure) const
  {
    return coefficient > 0.0 && !(opening * opening * std::pow(pressure, exponent) > coefficient);
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

  /// Lights points of a crack. \param reach of the flame from its start [m] \param temperature of the faces
  /// at each point, below and above [K]; empty where no particle has heat
  void spread(const State<D>& state, const FacePoints<D>& points, int crack, const Ignition<D>& ignition,
              double reach, const View<double* [2]>& temperature) const;

  /// Finds the lit points of a crack at which the flame is not quenched. \param gap between touching faces
  /// [m] \param pressure of the gas, in addition to that of each point where those are given [Pa]
  void quench(const FacePoints<D>& points, int crack, const Quenching& law, double gap, double pressure,
              const View<double*>& ofPoints) const;

  const View<int*>& burning() const { return burning_; } ///< not 0 where a point burns

  void serialize(Archive& archive);

private:
  View<int*> lit_, burning_;
};

} // namespace Rhegma::combustion
