#include "scene/BondedGroups.hpp"

#include "base/EntryValue.hpp"
#include "base/Numbers.hpp"

#include <algorithm>
#include <numeric>
#include <sstream>

namespace Rhegma
{

std::vector<std::string> splitNames(const std::string& list)
{
  std::vector<std::string> names;
  std::istringstream text(list);
  for (std::string name; std::getline(text, name, ',');)
    names.push_back(trimmed(name));
  return names;
}

BondedGroups bondedGroups(const Teuchos::ParameterList& bodies, const std::vector<std::string>& names)
{
  std::vector<int> root(names.size()); // the first body of each body's group
  std::iota(root.begin(), root.end(), 0);
  for (std::size_t b = 0; b < names.size(); ++b)
  {
    const auto* const bonded = valueIf<std::string>(bodies.sublist(names[b]), "Bonded To");
    if (bonded == nullptr)
      continue;
    for (const std::string& other : splitNames(*bonded))
    {
      const auto found = std::find(names.begin(), names.end(), other);
      if (found == names.end())
        continue;
      const int one = root[b], two = root[found - names.begin()];
      std::replace(root.begin(), root.end(), std::max(one, two), std::min(one, two));
    }
  }
  BondedGroups groups;
  groups.of.resize(names.size());
  for (std::size_t b = 0; b < names.size(); ++b)
  {
    if (root[b] == static_cast<int>(b))
    {
      groups.of[b] = groups.count();
      groups.names.push_back(names[b]);
      continue;
    }
    groups.of[b] = groups.of[root[b]];
    groups.names[groups.of[b]] += " + " + names[b];
  }
  return groups;
}

} // namespace Rhegma
