#pragma once
/// Heat in the bodies: conduction, sources, surfaces, and what temperature does to stress and stress to
/// temperature.

#include "plan/Effect.hpp"

namespace Rhegma::thermal
{

/// The effect `Thermal`.
EffectEntry thermalEntry();

/// Its section, and what no single parameter of a scene can show wrong.
Section thermalSection();
void checkThermal(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors);

} // namespace Rhegma::thermal
