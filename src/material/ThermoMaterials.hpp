#pragma once
/// From the Materials section of a scene to thermal properties.

#include "material/ThermoTables.hpp"

#include <Teuchos_ParameterList.hpp>

#include <string>
#include <vector>

namespace Rhegma
{

/// Names of the properties of a material that are tables of temperature, in its order.
std::vector<std::string> tabulatedProperties(const Teuchos::ParameterList& material);

/// The temperatures of all tables of a material [K], rising; empty where no property is a table.
std::vector<double> tableTemperatures(const Teuchos::ParameterList& material);

/// The material with every table replaced by its value at a temperature [K].
Teuchos::ParameterList materialAt(const Teuchos::ParameterList& material, double temperature);

/// Tables of all materials of a scene, in its order.
///
/// \param reference temperature of no thermal strain where a material does not give one [K]
/// \param mechanics whether there is stress
/// Throws std::invalid_argument, with the path of the parameter, for what is missing or wrong.
ThermoTables makeThermoTables(const Teuchos::ParameterList& materials, Plane plane, double reference,
                              bool mechanics);

} // namespace Rhegma
