#pragma once
/// Numbers as text, read strictly: "1.5Pa" is not a number, and nothing depends on the locale.

#include <optional>
#include <string>
#include <vector>

namespace Rhegma
{

/// Without white space at both ends.
std::string trimmed(const std::string& text);

/// A real number, white space around it allowed; "nan" and "inf" are read as such. None if the text is
/// anything else.
std::optional<double> parseReal(const std::string& text);

/// A whole number that fits an int; "2.0" and "1e3" count as whole. None if the text is anything else.
std::optional<int> parseInteger(const std::string& text);

/// "{1, 2}", "1, 2" or "1 2". None if an item is not a number.
std::optional<std::vector<double>> parseReals(const std::string& text);

/// The value as an int, if it is whole and fits one.
std::optional<int> wholeNumber(double value);

/// The shortest text of the number, exact to 10 digits.
std::string formatReal(double value);

/// All digits of the number, so that reading the text gives the same one.
std::string formatExactly(double value);

/// "{1, 2}", each number with all of its digits, so that reading it gives the same numbers.
std::string formatReals(const std::vector<double>& values);

/// A time [s], length [m] or energy [J] for a message: four digits with a unit prefix, such as "473.6 us",
/// "1.25 mm" or "70.3 mJ".
std::string readableTime(double seconds);
std::string readableLength(double metres);
std::string readableEnergy(double joules);

} // namespace Rhegma
