#pragma once
/// Which effects a scene may ask for: those that are built in, and those that an application brings.

#include "plan/Effect.hpp"

namespace Rhegma
{

/// Adds an effect of the application's own to those that scenes may ask for; it is then as good as one that
/// is built in. It starts after those that are there already.
///
/// Call it before the Simulation or the schema that is to know it is made. Throws std::invalid_argument where
/// an effect or a section of the core has its section's name, or where it can't be made for both dimensions.
void addEffect(EffectEntry entry);

/// The effects of packages/ (made by CMake from packages/Packages.cmake).
const std::vector<EffectEntry>& builtInEffects();

/// What the effects of a scene declare.
RunOptions declaredOptions(const Teuchos::ParameterList& scene);

/// Sections of effects that were switched off when this program was built (the same).
const std::vector<std::string>& effectsLeftOut();

} // namespace Rhegma
