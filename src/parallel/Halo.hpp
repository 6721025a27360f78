#pragma once
/// Nodes that particles of several ranks add to, and how their sums come about.

#include "grid/Tree.hpp"
#include "parallel/Division.hpp"

#include <memory>

namespace Rhegma
{

class NeighbourSums;
struct SharedRows;

/// The nodes of a rank's window, those of refined cells included, that lie in windows of other ranks too.
/// Nodes of refined cells count only where they are a cell or more inside both windows: a rank knows there
/// which nodes hang, and its particles reach no others.
///
/// Its sum over the ranks is the same number everywhere to the last digit (NeighbourSums), and what ranks
/// compute from it afterwards is too.
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
  std::unique_ptr<NeighbourSums> sums_;
  View<int*> nodes_;
  View<char*> foreign_;
};

} // namespace Rhegma
