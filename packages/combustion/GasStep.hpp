#pragma once
/// The gas of cracks and its pressure on their faces.

#include "combustion/BurnState.hpp"

namespace Rhegma::combustion
{

/// Finds the pressure of the gas in a crack, and pushes its faces with it. Gas without a volume, or without a
/// face to push, ends the run (State::failure).
template <int D>
void pushByGas(State<D>& state, const BurnState<D>& burn, Burning<D>& b);

/// Records the work of the gas on the faces in this step, less that against the outside pressure. Collective.
template <int D>
void recordGasWork(State<D>& state, const BurnState<D>& burn, Burning<D>& b);

} // namespace Rhegma::combustion
