#pragma once
/// The effects that a scene may use: built-in ones, and those that an application adds.

#include "plan/Effect.hpp"

namespace Rhegma
{

/// Adds an effect of an application; scenes use it like a built-in one. It starts after the existing effects.
///
/// Call it before making the Simulation or schema that uses it. Throws std::invalid_argument where an effect
/// or a section of the core has its section's name, or where it can't be made for both dimensions.
void addEffect(EffectEntry entry);

/// The effects of packages/ (made by CMake from packages/Packages.cmake).
const std::vector<EffectEntry>& builtInEffects();

/// What the effects of a scene declare.
RunOptions declaredOptions(const Teuchos::ParameterList& scene);

/// Sections of effects that were switched off in this build (also made by CMake).
const std::vector<std::string>& effectsLeftOut();

} // namespace Rhegma
