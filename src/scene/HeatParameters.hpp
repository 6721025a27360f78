#pragma once
/// Thermal parameters outside of the section Thermal.

#include "scene/Schema.hpp"

#include <vector>

namespace Rhegma
{

/// Adds rules to the core sections that refuse thermal parameters in a scene without heat.
void addHeatRules(std::vector<Section>& core);

} // namespace Rhegma
