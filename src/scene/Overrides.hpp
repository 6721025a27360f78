#pragma once
/// Changes of a scene from the command line.

#include "scene/Schema.hpp"

#include <Teuchos_ParameterList.hpp>

#include <string>
#include <vector>

namespace Rhegma
{

/// Applies "Section:Sub:Parameter=value". A fixed section that the scene lacks is added; a user-named sublist
/// must exist. Arrays are written as "{1, 2}", "1, 2" or "1 2"; with a unit, "2 mm" or "{1, 2} mm".
void applyOverride(Teuchos::ParameterList& scene, const std::string& text, const SceneSchema& schema,
                   std::vector<SceneError>& errors);

} // namespace Rhegma
