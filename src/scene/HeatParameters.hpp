#pragma once
/// What a scene says of heat outside of the section that provides it.

#include "scene/Schema.hpp"

#include <vector>

namespace Rhegma
{

/// Adds rules to the sections of the core for what has no effect in a scene without heat.
void addHeatRules(std::vector<Section>& core);

} // namespace Rhegma
