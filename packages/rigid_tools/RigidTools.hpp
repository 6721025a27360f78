#pragma once
/// Rigid tools.

#include "plan/Effect.hpp"

namespace Rhegma::rigid_tools
{

/// The effect `Rigid Tools`: shapes without particles that press and slide on bodies. They are at rest, have
/// a prescribed motion, or move as a mass.
EffectEntry rigidToolsEntry();

} // namespace Rhegma::rigid_tools
