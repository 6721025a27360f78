#pragma once
/// Checks of a surface of triangles that is to bound a solid, and the mending of mistakes with only
/// one possible correction.

#include "geometry/SimplexTree.hpp"
#include "geometry/SurfaceMesh.hpp"

#include <string>
#include <vector>

namespace Rhegma::Geometry
{

/// A surface for a Solid.
template <int D>
struct MendedSurface
{
  Simplices<D> surface;
  double resolution = 0.0;          ///< rounding of positions, in the unit of the file
  std::vector<std::string> notes{}; ///< what was mended, a message each
};

/// A closed surface that does not meet itself, with normals out of the solid.
///
/// Mended, with a message: points that differ by rounding are merged, triangles without area and repeated
/// ones are left out, triangles are turned. Positions in notes and messages are those of the file.
///
/// \throws std::invalid_argument, whose message says what is wrong, how often and where, for a surface that
/// is open, has edges of more than two triangles, has one side only, meets itself, or has a shell of which it
/// is not certain whether it is a cavity
MendedSurface<3> mendSurface(const SurfaceMesh& mesh);

} // namespace Rhegma::Geometry
