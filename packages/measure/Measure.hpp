#pragma once
/// The effect `Measure`: numbers for the summary that only few scenes want.

#include "plan/Effect.hpp"

namespace Rhegma::measure
{

EffectEntry measureEntry();

} // namespace Rhegma::measure
