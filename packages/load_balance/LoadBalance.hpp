#pragma once
/// Load balance: the domain is divided again when the load of the ranks has become uneven.

#include "plan/Effect.hpp"

namespace Rhegma::load_balance
{

/// The effect `Load Balance`.
EffectEntry loadBalanceEntry();

/// What the particles of this rank cost in a step of the run: one each, and twice as much with each level
/// whose steps are half as long.
template <int D>
double costOfParticles(const State<D>& state);

} // namespace Rhegma::load_balance
