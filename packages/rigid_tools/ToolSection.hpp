#pragma once
/// The section `Rigid Tools` of a scene.

#include "scene/Schema.hpp"

namespace Rhegma::rigid_tools
{

/// Its parameters, and what it does not go together with.
Section toolSection();

/// Checks each tool: shape, motion, bodies.
void checkTools(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors);

} // namespace Rhegma::rigid_tools
