#pragma once
/// Triangles in 3D, and their preparation as a crack.

#include "geometry/SurfaceMesh.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace Rhegma::surface
{

/// Two points, the one with the smaller index first.
using Edge = std::pair<int, int>;
inline Edge edgeOf(int a, int b) { return std::minmax(a, b); }

using Geometry::SurfaceMesh;

/// Merges points closer than `tolerance` [m]; the first of them stays.
void weld(SurfaceMesh& mesh, double tolerance);

/// Gives all triangles the orientation of the first.
///
/// \throws std::invalid_argument for a triangle without area, an edge with more than two triangles, a surface
/// of several pieces, one that has only one side, and one without a border
void orient(SurfaceMesh& mesh);

/// Splits edges longer than 1.4 of `edge` in the middle, the longest of a triangle first, and removes those
/// shorter than 0.5 of it if that turns no triangle by more than 15 degrees. The border does not move where
/// it bends by more than that.
void remesh(SurfaceMesh& mesh, double edge);

} // namespace Rhegma::surface
