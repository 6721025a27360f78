#pragma once
/// A stage of a step, and its failure.

#include "plan/Plan.hpp"

namespace Rhegma
{

/// Throws RunError with the failure of the state, and when it happened.
template <int D>
[[noreturn]] void stopRun(const State<D>& state);

/// Calls what belongs to a stage. Throws RunError where it fails; with several ranks the failure waits until
/// all know of it.
template <int D>
void runStage(Plan<D>& plan, State<D>& state, Stage stage);

/// Reduces over the ranks what they need to go on: the fastest speed, whether to sort, and a failure. Throws
/// RunError on all ranks where one has failed. Collective.
template <int D>
void agree(State<D>& state);

} // namespace Rhegma
