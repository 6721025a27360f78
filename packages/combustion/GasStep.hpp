#pragma once
/// The gas of cracks and their faces push each other.

#include "combustion/BurnState.hpp"

namespace Rhegma::combustion
{

/// Finds the pressure of the gas in a crack, and pushes its faces with it. Gas that has no room, or no face
/// to push, ends the run (State::failure).
template <int D>
void pushByGas(State<D>& state, const BurnState<D>& burn, Burning<D>& b);

/// Books what the gas did on the faces in this step; the atmosphere takes the part that it presses against.
/// Collective.
template <int D>
void recordGasWork(State<D>& state, const BurnState<D>& burn, Burning<D>& b);

} // namespace Rhegma::combustion
