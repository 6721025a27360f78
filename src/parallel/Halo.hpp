#pragma once
/// Nodes that particles of several ranks add to, and how their sums come about.

#include "parallel/Division.hpp"
#include "state/Types.hpp"

#include <memory>

namespace Rhegma
{

/// The nodes of a rank's window that lie in windows of other ranks too.
///
/// Shares of such a node go to its owner, which adds them and sends the sum to all that have the node (Tpetra
/// Export and Import), so that it is the same number everywhere to the last digit, and what ranks compute
/// from it afterwards is too.
template <int D>
class Halo
{
public:
  Halo(const Ranks& ranks, const Division<D>& division);
  ~Halo();

  /// Replaces columns first .. first + count - 1 of shared nodes by their sums over the ranks. Collective.
  /// \param rows `width` numbers for each node of the window
  void sum(double* rows, int width, int first, int count) const;

  /// The shared nodes, by their numbers in the window, ascending.
  const View<int*>& nodes() const { return nodes_; }
  /// By node of the window: not 0 where another rank owns it, so that sums over all nodes count it once.
  const View<char*>& foreign() const { return foreign_; }

private:
  class Plan;
  std::unique_ptr<Plan> plan_;
  View<int*> nodes_;
  View<char*> foreign_;
};

} // namespace Rhegma
