#pragma once
/// Constants of the library of materials in summary.json.

#include "scene/Schema.hpp"

#include <Teuchos_ParameterList.hpp>

#include <nlohmann/json.hpp>

namespace Rhegma
{

/// Adds the list `library` of what a validated scene has from the library: `where`, the path of a list of the
/// scene, `material`, its `values` in SI units, and the names `written` of those that the scene has itself.
void reportLibrary(const Teuchos::ParameterList& scene, const SceneSchema& schema, nlohmann::json& summary);

} // namespace Rhegma
