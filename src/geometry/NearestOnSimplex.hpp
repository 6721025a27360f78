#pragma once
/// The point of a segment or triangle that is nearest to another point.

#include "base/Types.hpp"

#include <algorithm>

namespace Rhegma::Geometry
{

/// The point of a simplex that is nearest to another point.
template <int D>
struct Foot
{
  double weight[D]; ///< of the simplex's vertices
  int vertex;       ///< the point is this vertex of the simplex; -1: it is none
  int facet;        ///< else it lies on this facet; -1: inside
};

/// Nearest point of a segment.
KOKKOS_INLINE_FUNCTION Foot<2> footOn(const Vector<2> (&corner)[2], const Vector<2>& x)
{
  const Vector<2> along = corner[1] - corner[0];
  const double at = dot(x - corner[0], along) / dot(along, along);
  if (at <= 0.0)
    return {{1.0, 0.0}, 0, -1};
  if (at >= 1.0)
    return {{0.0, 1.0}, 1, -1};
  return {{1.0 - at, at}, -1, -1};
}

/// Nearest point of a triangle, by the regions of its plane (Ericson, Real-Time Collision Detection, Morgan
/// Kaufmann 2005, section 5.1.5).
KOKKOS_INLINE_FUNCTION Foot<3> footOn(const Vector<3> (&corner)[3], const Vector<3>& x)
{
  const Vector<3> ab = corner[1] - corner[0], ac = corner[2] - corner[0];
  const Vector<3> ax = x - corner[0], bx = x - corner[1], cx = x - corner[2];
  const double a1 = dot(ab, ax), a2 = dot(ac, ax);
  if (a1 <= 0.0 && a2 <= 0.0)
    return {{1.0, 0.0, 0.0}, 0, -1};
  const double b1 = dot(ab, bx), b2 = dot(ac, bx);
  if (b1 >= 0.0 && b2 <= b1)
    return {{0.0, 1.0, 0.0}, 1, -1};
  const double c1 = dot(ab, cx), c2 = dot(ac, cx);
  if (c2 >= 0.0 && c1 <= c2)
    return {{0.0, 0.0, 1.0}, 2, -1};
  const double wc = a1 * b2 - b1 * a2;
  if (wc <= 0.0 && a1 >= 0.0 && b1 <= 0.0)
  {
    const double t = a1 / (a1 - b1);
    return {{1.0 - t, t, 0.0}, -1, 2};
  }
  const double wb = c1 * a2 - a1 * c2;
  if (wb <= 0.0 && a2 >= 0.0 && c2 <= 0.0)
  {
    const double t = a2 / (a2 - c2);
    return {{1.0 - t, 0.0, t}, -1, 1};
  }
  const double wa = b1 * c2 - c1 * b2;
  if (wa <= 0.0 && b2 - b1 >= 0.0 && c1 - c2 >= 0.0)
  {
    const double t = (b2 - b1) / ((b2 - b1) + (c1 - c2));
    return {{0.0, 1.0 - t, t}, -1, 0};
  }
  const double sum = wa + wb + wc;
  return {{wa / sum, wb / sum, wc / sum}, -1, -1};
}

template <int D>
KOKKOS_INLINE_FUNCTION Vector<D> pointAt(const Vector<D> (&corner)[D], const Foot<D>& foot)
{
  Vector<D> x;
  for (int d = 0; d < D; ++d)
  {
    x[d] = 0.0;
    for (int i = 0; i < D; ++i)
      x[d] += foot.weight[i] * corner[i][d];
  }
  return x;
}

/// Distance of a point from a simplex [m].
template <int D>
KOKKOS_INLINE_FUNCTION double distanceToSimplex(const Vector<D> (&corner)[D], const Vector<D>& x)
{
  return norm(x - pointAt<D>(corner, footOn(corner, x)));
}

/// Distance of a point from the segment between a and b, in the plane or in 3D [m].
template <int D>
double distanceToSegment(const Vector<D>& x, const Vector<D>& a, const Vector<D>& b)
{
  const Vector<D> along = b - a;
  const double at = std::clamp(dot(x - a, along) / dot(along, along), 0.0, 1.0);
  return norm(x - a - at * along);
}

} // namespace Rhegma::Geometry
