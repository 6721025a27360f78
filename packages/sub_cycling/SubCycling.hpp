#pragma once
/// Subcycling: substeps in fine cells.

#include "plan/Effect.hpp"

namespace Rhegma::sub_cycling
{

/// The section `Sub-Cycling`: the step is that of the coarsest cells, and nodes of finer ones take 2, 4, ...
/// substeps (LocalSteps.hpp).
EffectEntry subCyclingEntry();

} // namespace Rhegma::sub_cycling
