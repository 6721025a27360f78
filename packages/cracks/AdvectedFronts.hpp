#pragma once
/// Fronts that a moving body advects through the cells.

#include "state/State.hpp"

#include <nlohmann/json_fwd.hpp>
#include <vector>

namespace Rhegma::cracks
{

/// Disables the front springs of a crack whose front has been advected through half a cell.
///
/// Springs make up for nodes that open a little too early, as long as a front stays among its nodes. A node
/// that comes to lie behind a front because its body moves has a spring that is not stretched like the
/// material there, and one that the front leaves has one that no longer belongs to it. Such a crack opens its
/// nodes by the rule without springs from then on (Sides.hpp), which is right in the mean over positions, and
/// up to half a cell off at one position.
template <int D>
class AdvectedFronts
{
public:
  /// Stores where the fronts are. Belongs at the start of a run, with the positions of the scene also where
  /// a checkpoint follows.
  void start(const State<D>& state);

  /// Marks the cracks whose springs are disabled (CrackSet::nearFront). Belongs after the cracks have moved.
  void update(State<D>& state);

  /// Adds a warning for each front whose springs are disabled.
  void report(const State<D>& state, nlohmann::json& summary) const;

private:
  void findMarks(const State<D>& state);
  /// Distance from where a front was at the start [cells].
  double advectedCells(const State<D>& state, std::size_t front) const;

  std::vector<Vector<D>> start_;
  std::vector<bool> disabled_;  ///< of each crack
  const int* marked_ = nullptr; ///< the views that have the marks; growth makes new ones
};

} // namespace Rhegma::cracks
