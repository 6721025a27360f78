#pragma once
/// Cells and nodes of this rank.

#include "grid/Blocks.hpp"
#include "grid/Grid.hpp"
#include "grid/Nodes.hpp"
#include "grid/Tree.hpp"
#include "parallel/NodalFieldTable.hpp"

#include <cmath>
#include <memory>

namespace Rhegma
{

template <int D>
struct Subdomain;

/// The lattice, its refined cells, the values of their nodes, and the blocks of cells over which kernels
/// loop.
template <int D>
struct Mesh
{
  Grid<D> grid;   ///< cells that this rank's particles can reach; the whole lattice on a single rank
  Tree<D> tree;   ///< refined cells; empty where none is
  Nodes<D> nodes; ///< mass, momentum and force
  NodalFieldTable<D> nodalFields;          ///< values that effects store on nodes from step to step
  Blocks<D> blocks;                        ///< particles by blocks of cells
  std::shared_ptr<Subdomain<D>> subdomain; ///< this rank's part; null on a single rank
  /// Displacement of all cells at the end of this step, where the grid moves with a support [m].
  Vector<D> ahead{};
  int subcycledLevels = 0; ///< number of the deepest levels that take substeps

  /// Edge of the smallest cells [m].
  double smallestSpacing() const { return std::ldexp(grid.spacing, -tree.deepest); }

  /// Edge of the smallest cells that take the whole step [m].
  double stepSpacing() const
  {
    const int own = tree.deepest < subcycledLevels ? tree.deepest : subcycledLevels;
    return std::ldexp(grid.spacing, own - tree.deepest);
  }
};

} // namespace Rhegma
