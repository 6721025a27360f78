#pragma once
/// Where a front is, by which what comes near it is found.

#include "geometry/Frame.hpp"
#include "state/CrackSet.hpp"

#include <vector>

namespace Rhegma::energy_release
{

/// Its end in 2D, its nodes in 3D; none of a front without nodes [m].
template <int D>
std::vector<Vector<D>> pointsOf(const CrackFront<D>& front)
{
  if constexpr (D == 2)
    return {front.position};
  std::vector<Vector<D>> points;
  for (const FrontNode<D>& node : front.nodes)
    points.push_back(node.position);
  return points;
}

/// Bounds of points; empty bounds of none.
template <int D>
Geometry::Bounds<D> boundsOf(const std::vector<Vector<D>>& points)
{
  Geometry::Bounds<D> bounds = Geometry::emptyBounds<D>();
  for (const Vector<D>& x : points)
    bounds.include(x);
  return bounds;
}

/// Whether two bounds come within a distance of each other along every axis [m].
template <int D>
bool areNear(const Geometry::Bounds<D>& one, const Geometry::Bounds<D>& other, double distance)
{
  for (int d = 0; d < D; ++d)
    if (one.lower[d] > other.upper[d] + distance || one.upper[d] < other.lower[d] - distance)
      return false;
  return true;
}

} // namespace Rhegma::energy_release
