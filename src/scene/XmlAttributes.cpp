#include "scene/XmlAttributes.hpp"

#include "scene/NearestName.hpp"

#include <algorithm>
#include <vector>

namespace Rhegma
{

namespace
{

/// What a scene may say, then what Teuchos adds where it writes a list.
const std::vector<std::string>& knownAttributes(std::string_view tag)
{
  static const std::vector<std::string> ofLists = {"name", "id", "docString"};
  static const std::vector<std::string> ofParameters = {
      "name", "type", "value", "id", "unit", "isDefault", "isUsed", "docString", "validatorId"};
  static const std::vector<std::string> none;
  return tag == "ParameterList" ? ofLists : tag == "Parameter" ? ofParameters : none;
}

} // namespace

std::string mistakeInAttributes(const XmlReader& tag)
{
  const std::vector<std::string>& known = knownAttributes(tag.tag());
  if (known.empty()) // the tag itself is refused
    return {};
  for (std::size_t k = 0; k < tag.numAttributes(); ++k)
  {
    const std::string_view name = tag.attribute(k).name;
    const auto start = [&] { return "<" + std::string(tag.tag()) + "> has "; };
    if (std::find(known.begin(), known.end(), name) == known.end())
    {
      const std::string nearest = nearestName(std::string(name), known);
      return start() + "no attribute \"" + std::string(name) + "\"; " +
             (nearest.empty()
                  ? "write " + asText({known.begin(), known.begin() + (known.size() > 3 ? 3 : 1)}, " and ") +
                        " only."
                  : "did you mean \"" + nearest + "\"?");
    }
    for (std::size_t other = 0; other < k; ++other)
      if (tag.attribute(other).name == name)
        return start() + "the attribute \"" + std::string(name) + "\" twice; keep one of the two.";
  }
  return {};
}

} // namespace Rhegma
