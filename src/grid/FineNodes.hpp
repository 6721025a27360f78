#pragma once
/// Numbers of the nodes of refined cells, and the masters of those that hang.

#include "grid/LeafList.hpp"

#include <map>

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
  std::vector<Cell> mastersOf(const LeafList<D>& leaves, const Cell& position) const;

  std::map<Cell, int> row_; ///< of the nodes that are not nodes of the lattice, by their position
};

} // namespace Rhegma
