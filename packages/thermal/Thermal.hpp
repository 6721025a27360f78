#pragma once
/// Heat in the bodies: conduction, sources, surfaces, and thermoelastic coupling.

#include "plan/Effect.hpp"

namespace Rhegma::thermal
{

/// The effect `Thermal`.
EffectEntry thermalEntry();

/// Its section, and the checks that involve several parameters.
Section thermalSection();
void checkThermal(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors);

} // namespace Rhegma::thermal
