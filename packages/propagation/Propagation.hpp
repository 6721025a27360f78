#pragma once
/// Cracks that run.

#include "plan/Effect.hpp"

namespace Rhegma::propagation
{

/// The effect `Propagation`: after each step every front whose energy release rate reaches the toughness
/// advances (CrackSet::advances) by a fraction of its cells, in the direction that follows from the stress
/// intensities. Energy Release computes the driving forces, and the effect Cracks makes the advances; they
/// communicate by state.cracks alone.
EffectEntry propagationEntry();

} // namespace Rhegma::propagation
