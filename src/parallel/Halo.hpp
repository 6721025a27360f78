#pragma once
/// Nodes that particles of several ranks add to, and their sums over the ranks.

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
/// Sums over the ranks are the same to the last digit on all of them (NeighbourSums), and so is what ranks
/// compute from them.
template <int D>
class Halo
{
public:
  /// \param tree of the rank's window
  Halo(const Ranks& ranks, const Division<D>& division, const Tree<D>& tree);
  ~Halo();

  /// Replaces columns first .. first + count - 1 of shared nodes by their sums over the ranks. Collective.
  /// All ranks must agree on whether there are enriched fields and which shared nodes have rows.
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
