#pragma once
/// A crack as vertices and simplices, in host memory.

#include "base/FacetEnds.hpp"
#include "base/Types.hpp"

#include <array>
#include <functional>
#include <vector>

namespace Rhegma::surface
{

/// Vertices and simplices of one crack: segments in 2D, triangles in 3D.
template <int D>
struct CrackMesh
{
  std::vector<Vector<D>> vertices; ///< [m]
  std::vector<std::array<int, D>> simplices;
  std::vector<std::array<int, D>>
      beyond; ///< neighbour beyond each facet, or a constant of base/FacetEnds.hpp
};

/// Whether a point lies in a region, for example in a body [m].
template <int D>
using Region = std::function<bool(const Vector<D>&)>;

/// Whether a region extends for a cell beyond a point. \param direction of any length \param cell [m]
template <int D>
bool extendsBeyond(const Region<D>& region, const Vector<D>& from, const Vector<D>& direction, double cell)
{
  for (const double step : {0.25, 0.5, 0.75, 1.0})
    if (!region(from + (step * cell / norm(direction)) * direction))
      return false;
  return true;
}

} // namespace Rhegma::surface
