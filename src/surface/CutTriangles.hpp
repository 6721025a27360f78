#pragma once
/// Triangles cut to a region.

#include "surface/CrackMesh.hpp"

#include <array>
#include <vector>

namespace Rhegma::surface
{

/// Cuts off the parts outside of a region, to 1e-3 of the edges: points near the region's border move onto
/// it, then triangles are cut (Labelle and Shewchuk, ACM Trans. Graph. 26 (2007) 57, in a surface). Cuts are
/// straight at corners of the region. Unused points are removed.
/// \tparam D 2: triangles in a plane; 3: in 3D
template <int D>
void cutTriangles(std::vector<Vector<D>>& points, std::vector<std::array<int, 3>>& triangles,
                  const Region<D>& region);

} // namespace Rhegma::surface
