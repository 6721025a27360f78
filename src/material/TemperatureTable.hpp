#pragma once
/// A property that the user gives as a function of temperature.

#include <string>
#include <utility>
#include <vector>

namespace Rhegma
{

/// A number, or a table "293:3e9, 400:2e9" of temperature:value pairs with straight lines between them, held
/// constant outside of them.
struct TemperatureTable
{
  std::vector<double> temperature; ///< [K], rising; one alone for a number
  std::vector<double> value;

  double operator()(double T) const;
  bool varies() const { return value.size() > 1; }

  /// \throws std::invalid_argument with the error in the text
  static TemperatureTable parse(const std::string& text);
};

} // namespace Rhegma
