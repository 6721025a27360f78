#pragma once
/// Everything that a scene may hold, the effects' sections included.

#include "plan/Effect.hpp"

namespace Rhegma
{

/// The core's sections, all boundary types among them, and those of some effects.
SceneSchema schemaOf(const std::vector<EffectEntry>& effects);

/// That of all known effects.
const SceneSchema& effectSchema();

} // namespace Rhegma
