#pragma once
/// Whether nodes have values.

#include "state/State.hpp"

namespace Rhegma
{

/// Whether nodes have mass, motion and forces: from the first step on. In equilibrium the first load step is
/// not over, and counted, before a load factor is found, but equilibria have been solved for others.
template <int D>
bool haveNodalValues(const State<D>& state)
{
  return state.clock.step > 0 || (state.method.equilibrium() && state.clock.settled);
}

} // namespace Rhegma
