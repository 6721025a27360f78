#pragma once
/// Load balance: ranks divide the domain anew where some of them have more to do than others.

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
