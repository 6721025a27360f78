#pragma once
/// The sections of the material point method itself with the types of boundary that are known.

#include "scene/Schema.hpp"

#include <vector>

namespace Rhegma
{

/// coreSections() with a variant of Boundaries for each type.
std::vector<Section> coreSections(const std::vector<Section>& boundaryTypes);

} // namespace Rhegma
