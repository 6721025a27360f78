#pragma once
/// The radii of heat sources by which Domain > Accuracy chooses cells.

#include "scene/CellNeeds.hpp"

namespace Rhegma::thermal
{

/// Adds the radii of the smallest round sources, of those that move and of those at rest. One that meets no
/// body while the run lasts is an error; a box, with a uniform source, has no radius.
void reportCells(const Teuchos::ParameterList& scene, CellNeeds& needs, std::vector<SceneError>& errors);

} // namespace Rhegma::thermal
