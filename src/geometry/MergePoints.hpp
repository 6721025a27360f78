#pragma once
/// Merging of points of a surface of triangles.

#include "geometry/SimplexTree.hpp"
#include "geometry/SurfaceMesh.hpp"

namespace Rhegma::Geometry
{

/// The surface with each position once; points that no triangle has are left out.
Simplices<3> mergeEqualPoints(const SurfaceMesh& mesh);

/// Pairs of points that were merged.
struct MergedPoints
{
  int pairs = 0;
  double farthest = 0.0; ///< largest distance of a pair
  Vector<3> at{};        ///< the first of them
};

/// Merges the ends of edges that are not longer than a distance.
MergedPoints mergeShortEdges(Simplices<3>& surface, double distance);

/// Merges those of some points that are not farther apart than a distance.
MergedPoints mergeNearPoints(Simplices<3>& surface, const std::vector<int>& points, double distance);

/// Leaves out triangles that have the same point twice. \return their number
int dropCollapsed(Simplices<3>& surface);

} // namespace Rhegma::Geometry
