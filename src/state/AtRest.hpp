#pragma once
/// Runs in which nothing ever moves.

#include "state/State.hpp"

namespace Rhegma
{

/// Whether a run is one of equilibrium from its start to its end. One that is to move has the laws of motion
/// from the start.
template <int D>
bool staysAtRest(const State<D>& state)
{
  return state.method.equilibrium() && state.method.analysis != Analysis::Preload && !state.method.handsOver;
}

} // namespace Rhegma
