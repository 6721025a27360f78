#pragma once
/// The closed shells of a surface of triangles, and their orientation.

#include "geometry/SimplexTree.hpp"

#include <string>
#include <vector>

namespace Rhegma::Geometry
{

/// Unconnected parts of a surface.
struct Shells
{
  int count = 0;
  std::vector<int> of;      ///< shell of each triangle
  std::vector<char> turned; ///< whether a triangle is oriented against the first of its shell
};

/// \param surface each edge of which belongs to two triangles
/// \throws std::invalid_argument for a shell with one side only
Shells findShells(const Simplices<3>& surface);

/// Turns triangles so that all normals point out of the solid: outer shells outwards, cavities inwards.
/// Removes shells without a volume. \param notes gets what was changed, a message each
/// \param resolution rounding of positions
/// \throws std::invalid_argument where a shell is inside another one and has the same orientation, which may
/// be a cavity or a part
void orientShells(Simplices<3>& surface, const Shells& shells, double resolution,
                  std::vector<std::string>& notes);

/// Which shells a shell lies inside, from the number of times that a ray meets each. \param tree of the items
/// \param shell of each item \param count of shells
template <int D>
std::vector<std::vector<int>> shellsAround(const Simplices<D>& surface, const SimplexTree<D>& tree,
                                           const std::vector<int>& shell, int count);

/// "(1, 2)", in the unit of the file.
template <int D>
std::string placeInFile(const Vector<D>& x);

} // namespace Rhegma::Geometry
