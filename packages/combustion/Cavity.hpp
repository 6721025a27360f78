#pragma once
/// The room between the faces of a crack, and which of them burn.

#include "transfer/FacePoints.hpp"

namespace Rhegma::combustion
{

/// Where faces burn: within a radius around a place, which grows with the speed of the flame.
template <int D>
struct Flame
{
  Vector<D> centre{};
  double radius = -1.0; ///< [m]; below 0: nothing burns
  bool everywhere = false;

  KOKKOS_INLINE_FUNCTION bool reaches(const FacePoints<D>& points, int k) const
  {
    if (everywhere)
      return true;
    double square = 0.0;
    for (int d = 0; d < D; ++d)
      square += (points.position(k, d) - centre[d]) * (points.position(k, d) - centre[d]);
    return radius >= 0.0 && square <= radius * radius;
  }
};

/// What the face points of one crack add up to. Areas in 2D are lengths times the thickness.
struct Cavity
{
  double area = 0.0;    ///< of one face [m2]
  double burning = 0.0; ///< of both faces that burn [m2]
  double felt = 0.0;    ///< of one face that nodes feel [m2]
};

/// All ranks have all points and find the same.
template <int D>
Cavity measureCavity(const State<D>& state, const FacePoints<D>& points, int crack, const Flame<D>& flame);

/// Area through which a crack opens at the surface of the body [m2]: the opening at its mouths.
template <int D>
double mouthArea(const State<D>& state, int crack);

/// Whether the crack has a mouth.
template <int D>
bool hasMouth(const CrackSet<D>& cracks, int crack);

} // namespace Rhegma::combustion
