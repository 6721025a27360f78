#pragma once
/// The branches and leaves of a tree on the host, before they are copied to views.

#include "grid/Branches.hpp"

namespace Rhegma
{

/// Branches and leaves by number. Positions count the finest cells from node 0 of the lattice.
template <int D>
class LeafList
{
public:
  using Cell = std::array<int, D>;
  static constexpr int corners = Tree<D>::corners;

  explicit LeafList(const Branches<D>& branches);

  std::vector<int> root;                       ///< as in Tree
  std::vector<std::array<int, corners>> child; ///< as in Tree
  std::vector<Cell> cell;                      ///< of each leaf, in cells of its level
  std::vector<int> level;                      ///< of each leaf

  const Branches<D>& branches() const { return branches_; }
  const Grid<D>& grid() const { return branches_.grid(); }
  int depth() const { return branches_.depth(); }
  int size() const { return static_cast<int>(cell.size()); }

  /// The leaf that is this cell of this level; -1 where there is none, and for cells of the lattice.
  int leafAt(int ofLevel, const Cell& at) const;

  /// Edge of a cell in finest cells.
  int edge(int ofLevel) const { return 1 << (depth() - ofLevel); }

  /// Position of a corner of a leaf.
  Cell corner(int leaf, int k) const;

  /// Whether a position is a node of the lattice, and which.
  bool onLattice(const Cell& fine) const;
  int latticeNodeAt(const Cell& fine) const;

  /// The lowest node of a cell of the lattice.
  int lowestNode(const Cell& lattice) const;

  /// Coordinates of a position [m].
  std::array<double, D> position(const Cell& fine) const;

private:
  void numberBranches();
  void listLeaves();

  const Branches<D>& branches_;
  std::vector<Cell> branchCell_;
  std::vector<int> branchLevel_;
  /// Branches and leaves of each level: numbers within the level, and that of its first one.
  std::vector<KeyNumbers> branchAt_, leafAt_;
  std::vector<int> firstBranch_, firstLeaf_;
};

} // namespace Rhegma
