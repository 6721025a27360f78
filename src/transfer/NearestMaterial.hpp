#pragma once
/// What a position is made of.

#include "state/State.hpp"

namespace Rhegma
{

/// Number of the material of the particle, of all ranks, whose centre is nearest to a position. Collective.
template <int D>
int materialAt(const State<D>& state, const Vector<D>& place);

} // namespace Rhegma
