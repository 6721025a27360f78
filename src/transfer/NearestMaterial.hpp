#pragma once
/// The material at a position.

#include "state/State.hpp"

namespace Rhegma
{

/// Number of the material of the particle, of all ranks, whose centre is nearest to x [m]. Collective.
template <int D>
int materialAt(const State<D>& state, const Vector<D>& x);

} // namespace Rhegma
