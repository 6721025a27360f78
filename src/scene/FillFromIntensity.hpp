#pragma once
/// Toughness from a critical stress intensity.
///
/// A list whose section has the parameters `K_Ic` and `Toughness` may give the first instead of the second.

#include "scene/SceneError.hpp"
#include "scene/Schema.hpp"

#include <Teuchos_ParameterList.hpp>

#include <string>
#include <vector>

namespace Rhegma
{

/// Adds what a section may have instead of its `Toughness`: `K_Ic`, and the name of a material of the
/// library.
void describeToughnessByOtherMeans(Section& section);

/// Sets Toughness = K_Ic^2 / E' [J/m2] in each list that has `K_Ic`, with the E' of the scene's materials at
/// small strain: E in plane stress, else E / (1 - nu^2). The value is marked as a default one
/// (ParameterEntry::isDefault). Errors where both are given, and where E' is not one number: of several
/// materials or of a temperature. Units have been converted; errors of materials are left to their checks.
void fillFromIntensity(Teuchos::ParameterList& scene, const SceneSchema& schema,
                       std::vector<SceneError>& errors);

} // namespace Rhegma
