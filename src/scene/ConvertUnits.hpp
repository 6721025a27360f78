#pragma once
/// Takes the values of a scene to the units of its schema.

#include "scene/Schema.hpp"

#include <Teuchos_ParameterList.hpp>

#include <vector>

namespace Rhegma
{

/// Converts every value that is given in a unit: with the attribute `unit` (ValueWithUnit), or as a text such
/// as "2.5 MPa" or "{0, 1} mm" where the parameter is a number, an array of real numbers, or a text or
/// function with a unit. Afterwards the list holds numbers in the units of the schema, and no ValueWithUnit.
///
/// In a table, and in a function of time, the unit is that of the values, not of temperatures or times. A
/// value whose unit is wrong is reported and removed, or stays without it where its parameter is no number.
void convertUnits(Teuchos::ParameterList& scene, const SceneSchema& schema, std::vector<SceneError>& errors);

} // namespace Rhegma
