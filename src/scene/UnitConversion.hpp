#pragma once
/// Conversion of the units that a user writes to those of the schema.

#include <string>

namespace Rhegma
{

/// Takes a number in one unit to another: factor * (x + offset).
struct UnitConversion
{
  double factor = 1.0;
  double offset = 0.0; ///< in the unit that is converted; other than zero only for temperatures

  /// A number that has a short decimal text in the other unit is exactly that one: 1.1 mm is 0.0011 m.
  double operator()(double x) const;
};

/// What the numbers of a parameter with the unit K are.
enum class TemperatureKind
{
  Absolute,  ///< a unit may count from another zero, as degC does
  Difference ///< of two temperatures
};

/// The conversion from a unit to another one of the same dimension. Angles are a dimension of their own, so
/// that Hz is no unit of an angular velocity.
///
/// \param given    as a user writes it, such as "kJ/m2", "W/(m K)" or "degC"; see libudunits2
/// \param expected a unit of the schema
/// \param kind     where the unit is K
/// \throws std::invalid_argument with the error in the unit, as it follows the path of a parameter
UnitConversion conversionOf(const std::string& given, const std::string& expected,
                            TemperatureKind kind = TemperatureKind::Absolute);

/// Whether numbers in a unit of the schema can be converted: not those of "m/s/Pa^n" or "Pa:m/s".
bool isConvertible(const std::string& unit);

} // namespace Rhegma
