#pragma once
/// The refined cells on the host, and the tree made of them.

#include "grid/KeyNumbers.hpp"
#include "grid/Tree.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace Rhegma
{

/// The refined cells of each level. Coordinates count cells of their level from node 0 of the lattice.
template <int D>
class Branches
{
public:
  using Cell = std::array<int, D>;

  explicit Branches(const Grid<D>& grid) : grid_(grid) {}

  /// Refines a cell and all its ancestors.
  void refine(int level, const Cell& cell);

  bool isRefined(int level, const Cell& cell) const;

  /// Refines further so that neighbours over faces, edges and corners differ by one level at most: each
  /// neighbour of the size of a refined cell must exist.
  void balance();

  /// Levels that have refined cells.
  int depth() const { return static_cast<int>(levels_.size()); }

  /// Refined cells of a level, ordered by their position.
  std::vector<Cell> cells(int level) const;

  const Grid<D>& grid() const { return grid_; }

  /// Moves the lattice. \param by displacement [m]
  void translate(const Vector<D>& by) { grid_.translate(by); }

  /// A number of a cell among those of its level, in the order of their positions.
  std::uint64_t key(const Cell& cell) const;

  /// Whether a cell of a level lies on the lattice.
  bool isInside(int level, const Cell& cell) const;

  /// The refined cells inside a window of the lattice, counted from its node 0. The depth stays the same, so
  /// that the finest cells have the same size.
  Branches within(const Grid<D>& window) const;

  bool operator==(const Branches& other) const;

  /// Bits of the number of a finest-level cell along an axis.
  static constexpr int bitsPerAxis = 21;

private:
  Cell cellOf(std::uint64_t key) const;

  Grid<D> grid_;
  std::vector<KeyNumbers> levels_; ///< refined cells of each level by their keys
};

/// A leaf of a tree: its level and position, counted in cells of the level from node 0.
template <int D>
struct LeafName
{
  int level;
  typename Branches<D>::Cell cell;
};

/// The leaves of the refined cells.
template <int D>
std::vector<LeafName<D>> leafNames(const Grid<D>& grid, const Tree<D>& tree);

/// The refined cells that have these leaves.
template <int D>
Branches<D> branchesOf(const Grid<D>& grid, const std::vector<LeafName<D>>& leaves);

template <int D>
Branches<D> branchesOf(const Grid<D>& grid, const Tree<D>& tree)
{
  return branchesOf(grid, leafNames(grid, tree));
}

/// Makes the tree of balanced branches. Increments the generation; views whose size changes are allocated
/// anew.
template <int D>
void buildTree(const Branches<D>& branches, Tree<D>& tree);

} // namespace Rhegma
