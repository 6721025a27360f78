#pragma once
/// Nodes that particles of several ranks add to, and how their sums come about.

#include "grid/Tree.hpp"
#include "parallel/Division.hpp"
#include "state/Types.hpp"

#include <memory>

namespace Rhegma
{

/// Which rows of an array belong to a node: those of its number and of its second field's, or where an array
/// has rows of its own, those that it gives to them.
struct SharedRows
{
  View<int*> second; ///< number of each node's second field, or -1; empty where there are none
  View<int*> rowOf;  ///< row of each node and second field, or -1; empty where it is its number

  KOKKOS_INLINE_FUNCTION int operator()(int node, int field) const
  {
    const int number = field == 0 ? node : second(node);
    return number < 0 || rowOf.extent(0) == 0 ? number : rowOf(number);
  }
};

/// The nodes of a rank's window, those of refined cells included, that lie in windows of other ranks too.
/// Nodes of refined cells count only where they are a cell or more inside both windows: a rank knows there
/// which nodes hang, and its particles reach no others.
///
/// Shares of such a node go to its owner, which adds them and sends the sum to all that have the node (Tpetra
/// Export and Import), so that it is the same number everywhere to the last digit, and what ranks compute
/// from it afterwards is too.
template <int D>
class Halo
{
public:
  /// \param tree of the rank's window
  Halo(const Ranks& ranks, const Division<D>& division, const Tree<D>& tree);
  ~Halo();

  /// Replaces columns first .. first + count - 1 of shared nodes by their sums over the ranks. Collective.
  /// Whether there are second fields, and which shared nodes have rows, is the same on all ranks.
  /// \param values `width` numbers a row
  void sum(const SharedRows& rows, double* values, int width, int first, int count) const;

  /// The shared nodes, by their rows, ascending.
  const View<int*>& nodes() const { return nodes_; }
  /// By node of the window and of its refined cells: not 0 where another rank owns it, so that sums over all
  /// nodes count it once.
  const View<char*>& foreign() const { return foreign_; }

private:
  class Plan;
  std::unique_ptr<Plan> plan_;
  View<int*> nodes_;
  View<char*> foreign_;
};

} // namespace Rhegma
