#pragma once
/// Checks of several parameters of the core's sections together.

#include "scene/SceneError.hpp"

#include <Teuchos_ParameterList.hpp>

#include <vector>

namespace Rhegma
{

/// Corners, cells of the domain, materials and bodies that others name, shapes and their position in the
/// domain, the axes of boundaries, histories that stay finite. Entries that are absent are not checked.
void crossCheckCore(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors);

/// Fills in the core's defaults that follow from other parameters: Output > History Interval.
void deriveDefaults(Teuchos::ParameterList& scene);

/// Adds a plane of symmetry on the axis of an axisymmetric scene whose domain reaches it: there is no radial
/// motion. Call it before validation.
void addAxis(Teuchos::ParameterList& scene);

} // namespace Rhegma
