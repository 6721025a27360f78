#pragma once
/// Balanced trees at random.

#include "grid/Branches.hpp"

#include <array>
#include <random>

namespace Rhegma
{
namespace Test
{

template <int D>
Grid<D> lattice()
{
  Vector<D> lower, upper;
  for (int d = 0; d < D; ++d)
  {
    lower[d] = -0.3 + 0.1 * d;
    upper[d] = lower[d] + 2.0;
  }
  return makeGrid<D>(lower, upper, 0.5);
}

/// Refines some cells down to a random level. \param deepest level that may come
template <int D>
Branches<D> randomBranches(const Grid<D>& grid, int deepest, std::mt19937& engine)
{
  Branches<D> branches(grid);
  const int depth = 1 + static_cast<int>(engine() % deepest);
  const int seeds = 1 + static_cast<int>(engine() % 3);
  for (int s = 0; s < seeds; ++s)
  {
    std::array<int, D> cell;
    for (int d = 0; d < D; ++d)
    {
      const int inside = grid.cells[d] - 2 * gridMargin; // of the domain
      cell[d] = (gridMargin << (depth - 1)) + static_cast<int>(engine() % (inside << (depth - 1)));
    }
    branches.refine(depth - 1, cell);
  }
  branches.balance();
  return branches;
}

} // namespace Test
} // namespace Rhegma
