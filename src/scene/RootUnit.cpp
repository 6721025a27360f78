#include "scene/RootUnit.hpp"

#include "base/Numbers.hpp"
#include "scene/UnitText.hpp"

#include <regex>

namespace Rhegma
{

namespace
{

/// The unit under a root, and what stands before and after it.
struct Divided
{
  std::string before, under, after;
  bool once = false; ///< the power is 3/2
};

std::optional<Divided> divide(const std::string& unit)
{
  static const std::regex root("(.*?)(?:sqrt ?\\( ?([A-Za-z]+) ?\\)|\xE2\x88\x9A ?\\(?([A-Za-z]+)\\)?)(.*)");
  static const std::regex power("(.*?)([A-Za-z]+)\\^?(?:\\*\\*)?(0?\\.5|\\(1/2\\)|1\\.5|\\(3/2\\))(.*)");
  std::smatch found;
  if (std::regex_match(unit, found, root))
    return Divided{found[1], found[2].matched ? found[2].str() : found[3].str(), found[4], false};
  if (std::regex_match(unit, found, power))
    return Divided{found[1], found[2], found[4], found[3] == "1.5" || found[3] == "(3/2)"};
  return {};
}

} // namespace

std::optional<std::string> squareOfRoot(const std::string& unit)
{
  const auto divided = divide(trimmed(unit));
  if (!divided || hasRoot(divided->before) || hasRoot(divided->after))
    return {};
  std::string before = trimmed(divided->before), after = trimmed(divided->after);
  const bool divisor = !before.empty() && before.back() == '/';
  while (!before.empty() && std::string(" */.").find(before.back()) != std::string::npos)
    before.pop_back();
  const char* const sign = divisor ? "/" : " ";
  if (divided->once) // the whole power stays with the rest
    before = before.empty() ? divided->under : before + sign + divided->under;
  const std::string rest =
      trimmed(before + (before.empty() || after.empty() || after[0] == '/' ? "" : " ") + after);
  return (rest.empty() ? (divisor ? "1" : "") : "(" + rest + ")^2") + (rest.empty() && !divisor ? "" : sign) +
         divided->under;
}

} // namespace Rhegma
