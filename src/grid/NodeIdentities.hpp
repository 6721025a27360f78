#pragma once
/// Identities of nodes that depend neither on their order nor on their number.

#include "grid/Tree.hpp"

#include <array>
#include <utility>
#include <vector>

namespace Rhegma
{

/// Identifies a node by its position on the lattice of the smallest cells that there can be, counted from
/// node 0 of the whole lattice: the same on every rank, and before and after cells are refined.
template <int D>
class NodeIdentities
{
public:
  using Identity = std::array<int, D>;

  /// \param finePosition positions of the nodes of refined cells (Tree::finePosition)
  NodeIdentities() = default;
  NodeIdentities(const Grid<D>& grid, const View<double* [D]>& finePosition);

  /// Number of nodes.
  int size() const { return grid_.numNodes + static_cast<int>(fine_.size()); }

  /// \param node a primary field
  Identity of(int node) const;

  /// The node of this identity, or -1 where this rank has none.
  int find(const Identity& identity) const;

  /// Position of the node of this identity, also of one that does not exist [m].
  Vector<D> position(const Identity& identity) const;

  /// Whether a node of this identity lies in a part of the lattice, its rim included.
  static bool isWithin(const Grid<D>& part, const Identity& identity);

  /// Whether it is a node of the lattice, which refinement neither adds nor removes.
  static bool isOfLattice(const Identity& identity);

private:
  Grid<D> grid_{};
  std::vector<Identity> fine_;
  std::vector<std::pair<Identity, int>> sorted_; ///< nodes of refined cells by identity
};

} // namespace Rhegma
