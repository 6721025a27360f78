#pragma once
/// Distances between paths of crack fronts.

#include <vector>

namespace Rhegma::program
{

/// Distance of two points [m], each of 2 or 3 coordinates; not a number where they have different numbers of
/// coordinates, or none.
double distanceBetween(const std::vector<double>& a, const std::vector<double>& b);

/// Largest distance of a point of the shorter path from the longer one [m]: what lies beyond the shorter
/// one's end is a matter of how far the front came, not of where it went. Not a number where a path has fewer
/// than two points. \param one, other points in order, as for distanceBetween()
double distanceBetweenPaths(std::vector<std::vector<double>> one, std::vector<std::vector<double>> other);

} // namespace Rhegma::program
