#pragma once
/// Bounds of points, by which what comes near a front is found.

#include "geometry/Frame.hpp"

#include <vector>

namespace Rhegma::energy_release
{

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
