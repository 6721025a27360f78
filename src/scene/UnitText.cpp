#include "scene/UnitText.hpp"

#include "base/Numbers.hpp"

#include <cstddef>

namespace Rhegma
{

namespace
{

bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// Also a byte of a letter or sign outside of ASCII, such as those of the micro and degree signs.
bool isLetter(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80;
}

/// Length of the number that a text starts with; 0 if it starts with none.
std::size_t lengthOfNumber(const std::string& text)
{
  std::size_t at = !text.empty() && (text[0] == '+' || text[0] == '-') ? 1 : 0;
  const auto skipDigits = [&]
  {
    const std::size_t from = at;
    while (at < text.size() && isDigit(text[at]))
      ++at;
    return at - from;
  };
  std::size_t digits = skipDigits();
  if (at < text.size() && text[at] == '.')
  {
    ++at;
    digits += skipDigits();
  }
  if (digits == 0)
    return 0;
  const std::size_t mantissa = at;
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E'))
  {
    ++at;
    if (at < text.size() && (text[at] == '+' || text[at] == '-'))
      ++at;
    if (skipDigits() == 0)
      at = mantissa;
  }
  return at;
}

/// Whether a decimal point stands in a power, as in "m^0.5", and not in a factor, as in "0.5 m".
bool isInPower(const std::string& unit, std::size_t point)
{
  std::size_t at = point;
  while (at > 0 && (isDigit(unit[at - 1]) || unit[at - 1] == '-' || unit[at - 1] == '('))
    --at;
  return at > 0 && (isLetter(unit[at - 1]) || unit[at - 1] == '^' || unit[at - 1] == '*');
}

/// Whether all numbers of a unit are whole powers of one digit, but for the 1 of "1/K".
bool hasOnlyPowers(const std::string& unit)
{
  for (std::size_t k = 0; k < unit.size(); ++k)
  {
    if (!isDigit(unit[k]))
      continue;
    if (k + 1 < unit.size() && (isDigit(unit[k + 1]) || unit[k + 1] == '.'))
      return false;
    if (k == 0 && unit[k] == '1' && unit.find_first_not_of(' ', 1) == unit.find('/'))
      continue;
    std::size_t sign = k;
    if (sign > 0 && unit[sign - 1] == '-')
      --sign;
    const char before = sign > 0 ? unit[sign - 1] : ' ';
    const bool twoStars = sign > 1 && before == '*' && unit[sign - 2] == '*';
    if (!isLetter(before) && before != '^' && before != ')' && !twoStars)
      return false;
  }
  return true;
}

} // namespace

bool hasRoot(const std::string& unit)
{
  for (const char* sign : {"sqrt", "\xE2\x88\x9A" /* root */, "\xC2\xBD" /* one half */, "1/2"})
    if (unit.find(sign) != std::string::npos)
      return true;
  for (std::size_t k = unit.find('.'); k != std::string::npos; k = unit.find('.', k + 1))
    if (k + 1 < unit.size() && isDigit(unit[k + 1]) && isInPower(unit, k))
      return true;
  return false;
}

std::optional<QuantityText> quantityOf(const std::string& text)
{
  const std::string all = trimmed(text);
  std::size_t end = 0;
  if (!all.empty() && all[0] == '{')
  {
    end = all.find('}');
    if (end == std::string::npos || !parseReals(all.substr(0, end + 1)))
      return {};
    ++end;
  }
  else
    end = lengthOfNumber(all);
  const std::string unit = trimmed(all.substr(end));
  if (end == 0 || unit.empty())
    return {};
  const std::size_t second = unit.find_first_not_of(' ', 1);
  const bool inverse =
      unit[0] == '1' && second != std::string::npos && unit[second] == '/' && all[end] == ' ';
  if (!isLetter(unit[0]) && unit[0] != '%' && !inverse)
    return {};
  return QuantityText{all.substr(0, end), unit};
}

std::string mistakeInUnitText(const std::string& given, const std::string& expected)
{
  const std::string start = "is given in \"" + given + "\"";
  constexpr std::size_t longest = 60;
  if (trimmed(given).empty())
    return "has an empty unit; write one such as " + expected + ", or leave the unit out.";
  if (given.size() > longest)
    return "has a unit of more than " + std::to_string(longest) + " characters; write one such as " +
           expected + ".";
  if (hasRoot(given))
    return start + ", a unit with a root, which this parameter does not have; " +
           (expected == "J/m2"
                ? "a critical stress intensity is the parameter K_Ic; as an energy in J/m2 it is "
                  "K^2 / E in plane stress, K^2 (1 - nu^2) / E in plane strain."
                : "write a unit such as " + expected + ".");
  for (const char c : given)
    if (!isLetter(c) && !isDigit(c) && std::string(" .*/^-()%").find(c) == std::string::npos)
      return start + ", which is no unit; write one such as " + expected + ".";
  if (!hasOnlyPowers(given))
    return start +
           "; a unit has no numbers other than whole powers, as in kg/m3: put the number into the value.";
  return {};
}

} // namespace Rhegma
