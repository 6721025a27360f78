#pragma once
/// Bodies that come near to a front of a crack that does not cut them.

#include "state/State.hpp"

namespace Rhegma::energy_release
{

/// Warns once of a front of which a body that is kept apart from the cracked one is nearer than a radius [m].
/// Forces of contact on the cracked body act as loads do: inside of the domain integral they are part of it,
/// where its weight falls they are multiplied by the slope of the weight (LoadsInRing.hpp).
template <int D>
void warnOfBodies(State<D>& state, const CrackFront<D>& front, double radius);

} // namespace Rhegma::energy_release
