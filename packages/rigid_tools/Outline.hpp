#pragma once
/// The outline of a shape, for pictures.

#include "geometry/Shape.hpp"
#include "state/ToolOutline.hpp"

namespace Rhegma::rigid_tools
{

/// Segments (2D) or triangles (3D) along the surface of a shape. Round parts have 64 points on a circle in 2D
/// and 32 in 3D; pieces of a part that are not on the surface of the whole shape are left out. Ends of
/// prisms, and shapes of voxels, have none.
template <int D>
ToolOutline<D> outlineOf(const Shape<D>& shape);

} // namespace Rhegma::rigid_tools
