#pragma once
/// The section `Cracks` of a scene.

#include "plan/Effect.hpp"

namespace Rhegma::cracks
{

Section crackSection();

/// Adds an error for each crack that has no shape, more than one, or parts of another.
void checkCracks(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors);

} // namespace Rhegma::cracks
