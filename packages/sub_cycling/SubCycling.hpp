#pragma once
/// Smaller steps where cells are smaller.

#include "plan/Effect.hpp"

namespace Rhegma::sub_cycling
{

/// The section `Sub-Cycling`: the step is that of the largest cells, and nodes of smaller ones take 2, 4, ...
/// steps meanwhile (LocalSteps.hpp).
EffectEntry subCyclingEntry();

} // namespace Rhegma::sub_cycling
