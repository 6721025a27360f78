#pragma once
/// Ids of particles that come and go.

#include "state/State.hpp"

namespace Rhegma::adaptivity
{

/// Gives particles whose id is -1 the smallest ids that are free, in the order of the particles, rank by
/// rank. Collective.
template <int D>
void nameParticles(State<D>& state);

} // namespace Rhegma::adaptivity
