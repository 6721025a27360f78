#pragma once
/// The size of cells on the host.

#include "grid/Branches.hpp"

#include <cmath>

namespace Rhegma
{

/// Edge of the cell at a position [m]; that of the lattice outside of the refined cells.
template <int D>
double leafEdge(const Branches<D>& refined, const Vector<D>& x)
{
  const Grid<D>& grid = refined.grid();
  double edge = grid.spacing;
  for (int level = 0;; ++level, edge *= 0.5)
  {
    typename Branches<D>::Cell cell;
    for (int d = 0; d < D; ++d)
      cell[d] = static_cast<int>(std::floor((x[d] - grid.origin[d]) / edge));
    if (level >= refined.depth() || !refined.isInside(level, cell) || !refined.isRefined(level, cell))
      return edge;
  }
}

} // namespace Rhegma
