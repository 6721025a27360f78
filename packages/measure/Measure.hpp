#pragma once
/// The effect `Measure`: additional numbers in the summary, for scenes that request them.

#include "plan/Effect.hpp"

namespace Rhegma::measure
{

EffectEntry measureEntry();

} // namespace Rhegma::measure
