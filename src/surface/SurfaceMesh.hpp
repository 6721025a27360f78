#pragma once
/// Triangles in 3D, made ready to be a crack.

#include "base/Types.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace Rhegma::surface
{

/// Two points, the one with the smaller index first.
using Edge = std::pair<int, int>;
inline Edge edgeOf(int a, int b) { return std::minmax(a, b); }

struct SurfaceMesh
{
  std::vector<Vector<3>> points;             ///< [m]
  std::vector<std::array<int, 3>> triangles; ///< indices of points
};

/// Makes one point of points that lie closer than `tolerance` [m], in the order in which they come first.
void weld(SurfaceMesh& mesh, double tolerance);

/// Gives all triangles the orientation of the first.
///
/// \throws std::invalid_argument, in one sentence, for a triangle that has no area, an edge with more than
/// two triangles, a surface of several pieces, one that has only one side, and one without a border
void orient(SurfaceMesh& mesh);

/// Splits edges longer than 1.4 of `edge` in the middle, the longest of a triangle first, and takes away
/// those shorter than 0.5 of it where that turns no triangle by more than 15 degrees. The border stays where
/// it is where it bends by more than that.
void remesh(SurfaceMesh& mesh, double edge);

} // namespace Rhegma::surface
