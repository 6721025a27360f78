#pragma once
/// Names of nodes that depend neither on their order nor on how many there are.

#include "state/State.hpp"

#include <array>
#include <map>
#include <vector>

namespace Rhegma
{

/// Names a node by its place on the lattice of the smallest cells that there can be, counted from node 0 of
/// the whole lattice, so that what a node keeps can be saved whatever rank or row it has, and found again.
template <int D>
class NodeNames
{
public:
  using Name = std::array<int, D>;

  explicit NodeNames(const State<D>& state);
  /// \param finePlace places of the nodes of refined cells
  NodeNames(const Grid<D>& grid, const View<double* [D]>& finePlace);

  /// How many nodes there are.
  int size() const { return grid_.numNodes + static_cast<int>(fine_.size()); }

  /// \param node no second field
  Name of(int node) const;

  /// Appends the name to a list.
  void append(int node, std::vector<int>& list) const;

  /// The node whose name begins at an entry of a list, or -1 where there is no such node on this
  /// rank.
  int find(const std::vector<int>& list, std::size_t begin) const;

private:
  Grid<D> grid_;
  std::vector<Name> fine_;
  std::map<Name, int> numbers_; ///< of the nodes of refined cells
};

} // namespace Rhegma
