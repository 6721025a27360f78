#pragma once
/// The box in which a crack lies.

#include "geometry/Frame.hpp"
#include "state/CrackSet.hpp"

namespace Rhegma
{

/// Bounds of a crack [m]; empty ones of a crack that has no vertices. \param vertex of all cracks, on the
/// host
template <int D, class Vertices>
Geometry::Bounds<D> boundsOfCrack(const Crack<D>& crack, const Vertices& vertex)
{
  Geometry::Bounds<D> bounds = Geometry::emptyBounds<D>();
  for (int v = crack.firstVertex; v < crack.firstVertex + crack.numVertices; ++v)
  {
    Vector<D> x;
    for (int d = 0; d < D; ++d)
      x[d] = vertex(v, d);
    bounds.include(x);
  }
  return bounds;
}

} // namespace Rhegma
