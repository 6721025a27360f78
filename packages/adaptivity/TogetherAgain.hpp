#pragma once
/// Families of particles whose parts are on several ranks.

#include "state/State.hpp"

namespace Rhegma::adaptivity
{

/// Sends parts of families that are whole only over several ranks to the rank that has the first part, unless
/// one has gone so far away that this rank does not know the cells there. Particles must then be sorted anew.
/// Nothing where there is one rank. Collective. \param small the particles that may become one with others
template <int D>
void bringTogether(State<D>& state, const View<int*>& small);

} // namespace Rhegma::adaptivity
