#pragma once
/// The section `Cohesive Faces` of scenes.

#include "scene/Schema.hpp"

namespace Rhegma::cohesive_faces
{

Section cohesiveSection();

/// Checks of the parameters of each crack together.
void checkCohesion(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors);

} // namespace Rhegma::cohesive_faces
