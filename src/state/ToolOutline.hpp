#pragma once
/// Outlines of rigid tools.

#include "base/Types.hpp"

#include <array>
#include <vector>

namespace Rhegma
{

/// The surface of a rigid tool where it is now, for the fields that are written: segments (2D) or triangles
/// (3D).
template <int D>
struct ToolOutline
{
  std::vector<Vector<D>> points;         ///< [m]
  std::vector<std::array<int, D>> cells; ///< points of each segment or triangle
};

} // namespace Rhegma
