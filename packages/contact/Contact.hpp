#pragma once
/// The effect `Contact`: closed parts of cracks press and rub.

#include "plan/Effect.hpp"

namespace Rhegma::contact
{

EffectEntry contactEntry();

} // namespace Rhegma::contact
