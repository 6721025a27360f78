#pragma once
/// A step of the burning of a crack.

#include "combustion/BurnState.hpp"

namespace Rhegma::combustion
{

/// The solid next to the faces of a crack turns into gas; the gas heats the faces, flows along the crack and
/// out of it. Conserves the mass of solid, gas and vented gas to round-off. To be called while stencils and
/// nodal masses are those of the step. Collective.
template <int D>
void burnStep(State<D>& state, BurnState<D>& burn, Burning<D>& b);

} // namespace Rhegma::combustion
