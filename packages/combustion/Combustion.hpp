#pragma once
/// Cracks whose faces burn.

#include "plan/Effect.hpp"

namespace Rhegma::combustion
{

/// The effect `Combustion`: faces that burn at a rate that depends on the pressure, gas between them with a
/// mass and an energy of its own and one pressure in each crack, and that pressure on the faces
/// (docs/explanation/combustion.md).
EffectEntry combustionEntry();

/// Its section, and the checks that involve several parameters.
Section combustionSection();
void checkCombustion(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors);

} // namespace Rhegma::combustion
