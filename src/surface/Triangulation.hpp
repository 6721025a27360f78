#pragma once
/// Triangulation of a polygon with a given edge length.

#include "surface/CrackMesh.hpp"

#include <array>
#include <vector>

namespace Rhegma::surface
{

/// Triangles, each counter-clockwise, of points in a plane.
struct Triangulation
{
  std::vector<Vector<2>> points;             ///< [m]
  std::vector<std::array<int, 3>> triangles; ///< indices of points
};

/// Covers a simple polygon with triangles whose edges are about `spacing` long: cuts off ears (Meisters,
/// Amer. Math. Monthly 82 (1975) 648), puts points of a hexagonal lattice inside, and flips edges until the
/// triangulation is Delaunay's under the constraint of the border (Lawson, Math. Software III (1977) 161).
/// Every step preserves a valid triangulation, so the areas add up to the polygon's.
///
/// \param outline counter-clockwise, convex or not [m]; its edges are split into pieces no longer than
/// `spacing`
Triangulation triangulate(const std::vector<Vector<2>>& outline, double spacing);

/// Cuts off the parts outside of a region, to 1e-3 of the edges: points near the region's border move onto
/// it, then triangles are cut (Labelle and Shewchuk, ACM Trans. Graph. 26 (2007) 57, in a plane), and corners
/// of the region that the cuts miss are filled again. A hole or gap smaller than the distance of points is
/// not detected.
Triangulation cutToRegion(const Triangulation& whole, const Region<2>& region);

/// Twice the area of a triangle, positive for a counter-clockwise one [m2].
double doubleArea(const Vector<2>& a, const Vector<2>& b, const Vector<2>& c);

/// For each triangle and each of its edges (edge i is opposite to vertex i) the triangle beyond, or -1.
std::vector<std::array<int, 3>> findNeighbours(const std::vector<std::array<int, 3>>& triangles);

} // namespace Rhegma::surface
