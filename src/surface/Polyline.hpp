#pragma once
/// Polylines in a plane: pieces of equal length, crossings, clipping.

#include "surface/CrackMesh.hpp"

#include <array>
#include <vector>

namespace Rhegma::surface
{

/// Equal pieces of each segment that are no longer than `longest` [m].
std::vector<Vector<2>> splitSegments(const std::vector<Vector<2>>& points, double longest);

/// The segments of the first pair that meet, or turn back on one another, to a tolerance [m]: the numbers of
/// their first points; {-1, -1} where none do.
std::array<int, 2> firstCrossing(const std::vector<Vector<2>>& points, double tolerance);

/// Cuts off both ends outside of a region, to a resolution [m]. Points in between stay. Empty if no length is
/// left.
std::vector<Vector<2>> clipEnds(const std::vector<Vector<2>>& points, const Region<2>& region,
                                double resolution);

/// The segments between the points, in their order. \param beyond its first and its last end: a constant of
/// base/FacetEnds.hpp each
CrackMesh<2> polylineMesh(const std::vector<Vector<2>>& points, const std::array<int, 2>& beyond);

} // namespace Rhegma::surface
