#pragma once
/// Numbers of the nodes of refined cells, and the masters of those that hang.

#include "grid/LeafList.hpp"

#include <cstdint>

namespace Rhegma
{

/// Nodes at the corners of leaves: rows of nodal arrays, as Tree numbers them.
template <int D>
class FineNodes
{
public:
  using Cell = std::array<int, D>;
  static constexpr int corners = Tree<D>::corners;
  using Masters = std::array<int, Tree<D>::mastersPerCorner>;

  explicit FineNodes(const LeafList<D>& leaves);

  std::vector<std::array<int, corners>> masterCount; ///< as in Tree
  std::vector<std::array<Masters, corners>> master;  ///< as in Tree

  int size() const { return static_cast<int>(row_.size()); }

  /// Positions of the nodes that are not nodes of the lattice, in their order.
  std::vector<Cell> positions() const;

private:
  /// A position that is the corner of a leaf: the corners between which it hangs, itself alone where it hangs
  /// nowhere.
  struct Corner
  {
    int count = 0;
    std::array<Cell, Tree<D>::mastersPerCorner> master;
  };

  Corner cornerOf(const LeafList<D>& leaves, int leaf, int k) const;
  bool hangs(const LeafList<D>& leaves, int level, const Cell& position) const;
  void numberRows(const LeafList<D>& leaves, const std::vector<Corner>& found);
  int rowAt(const LeafList<D>& leaves, const Cell& position) const;

  KeyNumbers known_;               ///< nodes that are not nodes of the lattice, by their position
  std::vector<std::uint64_t> row_; ///< the same, sorted
  std::vector<int> rowOf_;         ///< row of nodal arrays of each number of `known_`
};

} // namespace Rhegma
