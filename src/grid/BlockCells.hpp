#pragma once
/// Which blocks have marked cells within reach.

#include "grid/Blocks.hpp"

namespace Rhegma
{

/// Whether a cell of a block, or one no more than `beyond` cells outside of it, is marked. \param marked by
/// the lowest node of a cell \param corner lowest cell of each block along the cut axes
template <int D>
KOKKOS_INLINE_FUNCTION bool anyCellMarked(const Grid<D>& grid, const View<char*>& marked,
                                          const View<int * [Blocks<D>::axes]>& corner, int block, int beyond)
{
  int low[D], count[D], all = 1;
  for (int k = 0; k < D; ++k)
  {
    const int axis = grid.axisOrder[k], cells = grid.cells[axis];
    const bool cut = k < Blocks<D>::axes;
    const int begin = cut ? corner(block, k) - beyond : 0;
    const int end = cut ? corner(block, k) + Blocks<D>::edge + beyond : cells;
    low[axis] = begin > 0 ? begin : 0;
    count[axis] = (end < cells ? end : cells) - low[axis];
    all *= count[axis];
  }
  for (int k = 0; k < all; ++k)
  {
    int at[D], rest = k;
    for (int d = 0; d < D; ++d)
    {
      at[d] = low[d] + rest % count[d];
      rest /= count[d];
    }
    if (marked(grid.nodeIndex(at)) != 0)
      return true;
  }
  return false;
}

} // namespace Rhegma
