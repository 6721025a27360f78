#pragma once
/// Triangles in 3D.

#include "base/Types.hpp"

#include <array>
#include <vector>

namespace Rhegma::Geometry
{

struct SurfaceMesh
{
  std::vector<Vector<3>> points;             ///< [m], or the unit of the file that they are from
  std::vector<std::array<int, 3>> triangles; ///< indices of points
};

} // namespace Rhegma::Geometry
