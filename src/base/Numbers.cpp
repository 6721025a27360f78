#include "base/Numbers.hpp"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string_view>

namespace Rhegma
{

namespace
{

std::string_view withoutBlanks(std::string_view text)
{
  const char* white = " \t\r\n";
  const auto first = text.find_first_not_of(white);
  return first == std::string_view::npos ? std::string_view()
                                         : text.substr(first, text.find_last_not_of(white) - first + 1);
}

std::optional<double> realOf(std::string_view text)
{
  std::string_view digits = withoutBlanks(text);
  if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-')
    digits.remove_prefix(1);
  double value = 0.0;
  const char* end = digits.data() + digits.size();
  const auto result = std::from_chars(digits.data(), end, value);
  if (digits.empty() || result.ptr != end)
    return {};
  if (result.ec == std::errc::result_out_of_range) // 1e999 or 1e-999
  {
    const auto exponent = digits.find_first_of("eE");
    const bool tiny = exponent != std::string_view::npos && digits[exponent + 1] == '-';
    return tiny ? 0.0 : std::numeric_limits<double>::infinity();
  }
  if (result.ec != std::errc())
    return {};
  return value;
}

} // namespace

std::string trimmed(const std::string& text) { return std::string(withoutBlanks(text)); }

std::optional<double> parseReal(const std::string& text) { return realOf(text); }

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
  std::string_view items = withoutBlanks(text);
  if (!items.empty() && items.front() == '{')
  {
    if (items.back() != '}')
      return {};
    items = withoutBlanks(items.substr(1, items.size() - 2));
  }
  std::vector<double> values;
  const bool commas = items.find(',') != std::string_view::npos;
  const char* separators = commas ? "," : " \t\r\n";
  std::size_t begin = 0;
  while (!items.empty() && begin <= items.size())
  {
    std::size_t end = items.find_first_of(separators, begin);
    if (end == std::string_view::npos)
      end = items.size();
    const std::string_view item = items.substr(begin, end - begin);
    begin = end + 1;
    if (!commas && item.empty()) // several blanks in a row
      continue;
    const auto value = realOf(item);
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

namespace
{

/// The value in four digits, with the largest prefix of its unit that leaves at least 1 before the point.
std::string withPrefix(double value, const char* unit, double largest)
{
  struct Prefix
  {
    double size;
    const char* name;
  };
  char text[40];
  for (const Prefix prefix :
       {Prefix{1e3, "k"}, {1.0, ""}, {1e-3, "m"}, {1e-6, "u"}, {1e-9, "n"}, {1e-12, "p"}})
    if (prefix.size <= largest && std::isfinite(value) && std::abs(value) >= 0.99995 * prefix.size)
    {
      std::snprintf(text, sizeof text, "%.4g %s%s", value / prefix.size, prefix.name, unit);
      return text;
    }
  std::snprintf(text, sizeof text, "%.4g %s", value, unit);
  return text;
}

} // namespace

std::string readableTime(double seconds) { return withPrefix(seconds, "s", 1.0); }
std::string readableLength(double metres) { return withPrefix(metres, "m", 1.0); }
std::string readableEnergy(double joules) { return withPrefix(joules, "J", 1e3); }

std::string formatReals(const std::vector<double>& values)
{
  std::string text = "{";
  for (const double value : values)
    text += (text.size() > 1 ? ", " : "") + formatExactly(value);
  return text + "}";
}

} // namespace Rhegma
