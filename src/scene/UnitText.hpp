#pragma once
/// Units as text: what a user can write, and names of dimensions.

#include <optional>
#include <string>

namespace Rhegma
{

/// What a text says where it is a number, or numbers in braces, and a unit.
struct QuantityText
{
  std::string value; ///< "2.5" or "{1, 2}"
  std::string unit;  ///< not empty
};

/// Divides "2.5 MPa", "2.5MPa" or "{0, 1} mm". None if the text is anything else, such as an expression.
std::optional<QuantityText> quantityOf(const std::string& text);

/// Whether a unit has a root or a power that is not whole.
bool hasRoot(const std::string& unit);

/// Why no unit is written in this form: numbers other than whole powers, fractional powers, characters. Empty
/// if it may be one. libudunits2 would read "m^0.5" as 0.5 and "10 mm" as 0.01 m.
/// \param given    the unit
/// \param expected the unit of the schema, for advice
std::string mistakeInUnitText(const std::string& given, const std::string& expected);

} // namespace Rhegma
