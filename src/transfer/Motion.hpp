#pragma once
/// The nodes' equation of motion with lumped mass.

#include "state/State.hpp"

namespace Rhegma
{

/// a = f / m and v = p / m + a dt on every node with mass; zero elsewhere.
template <int D>
void solveLumped(State<D>& state);

} // namespace Rhegma
