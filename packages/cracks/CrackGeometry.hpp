#pragma once
/// Where a place lies with respect to a crack.

#include "state/CrackSet.hpp"

namespace Rhegma::cracks
{

/// A place seen from a crack that is continued straight on beyond its ends.
struct Sight
{
  double distance; ///< from the continued crack, positive on side +1 [m]
  double behind; ///< by how far the place lies behind the nearest front, negative ahead of it; huge away from
                 ///< fronts [m]
  bool found;
  Vector<2> normal; ///< unit normal of the nearest segment, from side -1 to side +1
};

/// A crack's segments on the device.
struct Polyline
{
  View<double* [2]> vertex;
  int first;       ///< first vertex
  int last;        ///< last vertex
  bool frontFirst; ///< whether the first vertex is a front
  bool frontLast;
};

/// Looks at x from a polyline. Where the nearest point is a kink, the two segments' normals together decide
/// the side, so that sides change nowhere but on the continued crack (Baerentzen and Aanaes, IEEE Trans. Vis.
/// Comput. Graph. 11 (2005) 243).
KOKKOS_INLINE_FUNCTION Sight look(const Polyline& crack, const Vector<2>& x)
{
  Sight sight{0.0, 1e300, false, {0.0, 0.0}};
  double nearest = 1e300;
  for (int s = crack.first; s < crack.last; ++s)
  {
    const double ax = crack.vertex(s, 0), ay = crack.vertex(s, 1);
    const double tx = crack.vertex(s + 1, 0) - ax, ty = crack.vertex(s + 1, 1) - ay;
    const double length = std::sqrt(tx * tx + ty * ty);
    const double along = ((x[0] - ax) * tx + (x[1] - ay) * ty) / length;
    const bool isFirst = s == crack.first, isLast = s + 1 == crack.last;
    double at = along;
    if (!isFirst && at < 0.0)
      at = 0.0;
    if (!isLast && at > length)
      at = length;
    const double dx = x[0] - ax - at * tx / length, dy = x[1] - ay - at * ty / length;
    const double square = dx * dx + dy * dy;
    if (square >= nearest)
      continue;
    nearest = square;
    double nx = -ty / length, ny = tx / length;
    sight.normal = {nx, ny};
    const int other = at != along && at == 0.0 ? s - 1 : (at != along && at == length ? s + 1 : -1);
    if (other >= crack.first && other < crack.last)
    {
      const double ox = crack.vertex(other + 1, 0) - crack.vertex(other, 0);
      const double oy = crack.vertex(other + 1, 1) - crack.vertex(other, 1);
      const double otherLength = std::sqrt(ox * ox + oy * oy);
      nx -= oy / otherLength;
      ny += ox / otherLength;
    }
    const double side = dx * nx + dy * ny;
    sight.distance = side >= 0.0 ? std::sqrt(square) : -std::sqrt(square);
    sight.behind = 1e300;
    if (isFirst && crack.frontFirst)
      sight.behind = along;
    if (isLast && crack.frontLast && length - along < sight.behind)
      sight.behind = length - along;
    sight.found = true;
  }
  return sight;
}

} // namespace Rhegma::cracks
