#pragma once
/// Checks one entry of a scene against its parameter.

#include "scene/Schema.hpp"

#include <Teuchos_ParameterList.hpp>

#include <optional>
#include <string>

namespace Rhegma
{

/// Converts the entry to the type of the parameter without loss: a whole number to a real one, 3.0 to an
/// integer, numbers to an array of one, a number to a constant function of time. Checks range, choice,
/// finiteness and length, as the parameter's Teuchos validator does. An entry that is right is not changed.
///
/// \param dimension  2, 3, or 0 where the scene does not give it
/// \return the error message, or none
std::optional<std::string> normaliseValue(Teuchos::ParameterList& list, const Parameter& parameter,
                                          int dimension);

/// Sets the parameter to a value of its own type.
void setValue(Teuchos::ParameterList& list, const Parameter& parameter, const ParameterValue& value);

/// The same for a parameter that the list does not hold.
void addValue(Teuchos::ParameterList& list, const Parameter& parameter, const ParameterValue& value);

/// Reads a text, such as one from the command line, as a value of the parameter's type.
std::optional<ParameterValue> valueFromText(const Parameter& parameter, const std::string& text);

/// "a real number", "a whole number", "true or false", ...
std::string typeAsText(ParameterType type);

} // namespace Rhegma
