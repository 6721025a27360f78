#pragma once
/// The lengths of cracks by which Domain > Accuracy chooses cells.

#include "scene/CellNeeds.hpp"

namespace Rhegma::cracks
{

/// Adds the lengths of a scene's cracks: of each that has a front in material, from the front to the nearest
/// surface, and its own length (half of it between two fronts, a radius in 3D); in 2D also from the front to
/// the surface ahead, and the thickness of the body and of arms next to the crack. A crack that has no length
/// or lies outside of all bodies is an error.
///
/// Throws std::invalid_argument where the size of a crack is not known.
void reportCells(const Teuchos::ParameterList& scene, CellNeeds& needs, std::vector<SceneError>& errors);

} // namespace Rhegma::cracks
