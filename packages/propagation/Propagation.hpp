#pragma once
/// Cracks that run.

#include "plan/Effect.hpp"

namespace Rhegma::propagation
{

/// The effect `Propagation`: after each step every front whose energy release rate reaches the toughness is
/// asked to advance (CrackSet::advances), by a length tied to the cells at it and in the direction that the
/// stress intensities ask for. What drives fronts is measured by Energy Release, and the effect Cracks makes
/// them advance; they meet in state.cracks alone.
EffectEntry propagationEntry();

} // namespace Rhegma::propagation
