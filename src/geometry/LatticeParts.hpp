#pragma once
/// The parts of a lattice's cells that are inside a shape.

#include "geometry/Lattice.hpp"
#include "geometry/SeedRules.hpp"

namespace Rhegma::Geometry
{

/// Smaller fractions of a cell are rounding.
constexpr double tiny = 1e-9;

/// The parts of all cells, of each level in the order of its cells (sortByCell): cells are divided where the
/// rules say so, and by the surfaces that pass through them. Parts of any size: none is joined with another.
/// \param lattice of the shape (makeLattice)
template <int D>
PartsOfLevels<D> partsOfCells(const Lattice<D>& lattice, const Shape<D>& shape, const SeedRules<D>& rules);

} // namespace Rhegma::Geometry
