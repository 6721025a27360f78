#pragma once
/// What sources of heat ask of the cells that Domain > Accuracy chooses.

#include "scene/CellNeeds.hpp"

namespace Rhegma::thermal
{

/// Adds the radii of the smallest round sources, of those that move and of those at rest. One that meets no
/// body while the run lasts is an error; a box, which is evenly warm, asks for nothing.
void reportCells(const Teuchos::ParameterList& scene, CellNeeds& needs, std::vector<SceneError>& errors);

} // namespace Rhegma::thermal
