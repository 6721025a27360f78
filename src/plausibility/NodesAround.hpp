#pragma once
/// Nodes of the lattice around a position.

#include "grid/Grid.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma
{

/// Calls see(node, position) for nodes within so many cells of x along each axis.
template <int D, class See>
void forEachNode(const Grid<D>& grid, const Vector<D>& x, double cells, const See& see)
{
  int first[D], count[D], all = 1;
  for (int d = 0; d < D; ++d)
  {
    first[d] = std::max(0, static_cast<int>(std::ceil(grid.inCells(x[d], d) - cells)));
    count[d] =
        std::min(grid.cells[d], static_cast<int>(std::floor(grid.inCells(x[d], d) + cells))) - first[d] + 1;
    all *= std::max(0, count[d]);
  }
  for (int k = 0; k < all; ++k)
  {
    int at[D], rest = k;
    for (int d = 0; d < D; ++d)
    {
      at[d] = first[d] + rest % count[d];
      rest /= count[d];
    }
    see(grid.nodeIndex(at), grid.positionOf(at));
  }
}

/// How far a particle reaches: a cell and half of its longest edge, without nodes that it only touches
/// [cells]. \param edge its longest [m]
template <int D>
double reachOfParticle(const Grid<D>& grid, double edge)
{
  return (1.0 + 0.5 * edge * grid.inverse) * (1.0 - 1e-9);
}

} // namespace Rhegma
