#pragma once
/// The cells that hold particles, as a mesh.

#include "grid/Grid.hpp"
#include "output/Snapshot.hpp"

#include <vector>

namespace Rhegma
{

/// Quadrilaterals, counter-clockwise, or hexahedra, lower face first; each node is one point.
/// \param position x y z of one particle after another, z ignored in 2D [m]
template <int D>
Mesh cellMesh(const Grid<D>& grid, const std::vector<double>& position);

} // namespace Rhegma
