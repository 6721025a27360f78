#pragma once
/// Contact of bodies.

#include "plan/Effect.hpp"

namespace Rhegma::body_contact
{

/// The effect `Body Contact`: bodies that are not bonded move on their own, and act on each other where they
/// touch.
EffectEntry bodyContactEntry();

} // namespace Rhegma::body_contact
