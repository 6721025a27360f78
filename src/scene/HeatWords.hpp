#pragma once
/// What a scene says of heat outside of the section that provides it.

#include "scene/Schema.hpp"

#include <string>
#include <vector>

namespace Rhegma
{

/// Whether a type of boundary is one of heat alone.
bool isHeatBoundary(const std::string& type);

/// Adds rules to the sections of the core for what nobody would look at in a scene without heat.
void addHeatRules(std::vector<Section>& core);

} // namespace Rhegma
