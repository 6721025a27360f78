#pragma once
/// Everything that a scene may hold, the effects' sections included.

#include "scene/Schema.hpp"

namespace Rhegma
{

/// The core's sections and those of all known effects.
const SceneSchema& effectSchema();

} // namespace Rhegma
