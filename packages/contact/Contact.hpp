#pragma once
/// The effect `Contact`: contact and friction of the closed parts of cracks.

#include "plan/Effect.hpp"

namespace Rhegma::contact
{

EffectEntry contactEntry();

} // namespace Rhegma::contact
