#include "base/Numbers.hpp"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>

namespace Rhegma
{

std::string trimmed(const std::string& text)
{
  const char* white = " \t\r\n";
  const auto first = text.find_first_not_of(white);
  if (first == std::string::npos)
    return {};
  return text.substr(first, text.find_last_not_of(white) - first + 1);
}

std::optional<double> parseReal(const std::string& text)
{
  std::string digits = trimmed(text);
  if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-')
    digits.erase(0, 1);
  double value = 0.0;
  const char* end = digits.data() + digits.size();
  const auto result = std::from_chars(digits.data(), end, value);
  if (digits.empty() || result.ptr != end)
    return {};
  if (result.ec == std::errc::result_out_of_range) // 1e999 or 1e-999
  {
    const auto exponent = digits.find_first_of("eE");
    const bool tiny = exponent != std::string::npos && digits[exponent + 1] == '-';
    return tiny ? 0.0 : std::numeric_limits<double>::infinity();
  }
  if (result.ec != std::errc())
    return {};
  return value;
}

std::optional<int> wholeNumber(double value)
{
  if (std::floor(value) != value || value < std::numeric_limits<int>::min() ||
      value > std::numeric_limits<int>::max())
    return {};
  return static_cast<int>(value);
}

std::optional<int> parseInteger(const std::string& text)
{
  const auto value = parseReal(text);
  return value ? wholeNumber(*value) : std::nullopt;
}

std::optional<std::vector<double>> parseReals(const std::string& text)
{
  std::string items = trimmed(text);
  if (!items.empty() && items.front() == '{')
  {
    if (items.back() != '}')
      return {};
    items = trimmed(items.substr(1, items.size() - 2));
  }
  std::vector<double> values;
  const bool commas = items.find(',') != std::string::npos;
  const char* separators = commas ? "," : " \t\r\n";
  std::size_t begin = 0;
  while (!items.empty() && begin <= items.size())
  {
    std::size_t end = items.find_first_of(separators, begin);
    if (end == std::string::npos)
      end = items.size();
    const std::string item = items.substr(begin, end - begin);
    begin = end + 1;
    if (!commas && item.empty()) // several blanks in a row
      continue;
    const auto value = parseReal(item);
    if (!value)
      return {};
    values.push_back(*value);
  }
  return values;
}

std::string formatReal(double value)
{
  char text[40];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

std::string formatExactly(double value)
{
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

std::string formatReals(const std::vector<double>& values)
{
  std::string text = "{";
  for (const double value : values)
    text += (text.size() > 1 ? ", " : "") + formatExactly(value);
  return text + "}";
}

} // namespace Rhegma
