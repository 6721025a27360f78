#pragma once
/// What a scene says of heat outside of the section Thermal.

#include "scene/SceneError.hpp"

#include <Teuchos_ParameterList.hpp>

#include <string>
#include <vector>

namespace Rhegma
{

/// Adds an error for all that a scene without Thermal must not have, for nobody would look at it.
void refuseHeatWords(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors);

} // namespace Rhegma
