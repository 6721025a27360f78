#pragma once
/// Sides of particles ahead of a front that turns.

#include "state/State.hpp"

namespace Rhegma::cracks
{

/// Sets the side of particles to none that are of the front's crack, within a reach [m] of its front nodes,
/// and ahead of the nearest: they get a new side when the crack has advanced.
template <int D>
void forgetSidesAhead(const State<D>& state, const CrackFront<D>& front, double reach);

} // namespace Rhegma::cracks
