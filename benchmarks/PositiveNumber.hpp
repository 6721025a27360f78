#pragma once
/// Numbers on the command lines of benchmarks.

#include <stdexcept>
#include <string>
#include <type_traits>

namespace Rhegma::benchmarks
{

/// The number that follows an option, an int or a double. Throws std::invalid_argument where it is none, or
/// not above zero.
template <class Number>
Number positiveNumber(const std::string& option, const std::string& text)
{
  constexpr bool whole = std::is_same_v<Number, int>;
  std::size_t used = 0;
  Number value = 0;
  try
  {
    if constexpr (whole)
      value = std::stoi(text, &used);
    else
      value = std::stod(text, &used);
  }
  catch (const std::logic_error&)
  {
  }
  if (!(value > 0) || used != text.size())
    throw std::invalid_argument(option + " needs a positive " + (whole ? "whole " : "") + "number, not \"" +
                                text + "\"");
  return value;
}

} // namespace Rhegma::benchmarks
