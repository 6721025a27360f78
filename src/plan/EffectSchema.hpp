#pragma once
/// The schema of scenes, with the sections of effects.

#include "plan/Effect.hpp"

namespace Rhegma
{

/// The core's sections, all boundary types among them, and those of some effects.
SceneSchema schemaOf(const std::vector<EffectEntry>& effects);

/// The schema of all known effects.
const SceneSchema& effectSchema();

} // namespace Rhegma
