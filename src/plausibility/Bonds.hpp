#pragma once
/// Pairs of bodies that the scene says are bonded, and whether others are kept apart.

#include "base/EntryValue.hpp"
#include "base/Numbers.hpp"
#include "state/BodyGroup.hpp"
#include "state/State.hpp"

#include <set>
#include <sstream>
#include <string>
#include <utility>

namespace Rhegma
{

/// Whether an effect gives bodies that are not bonded a motion of their own at common nodes.
template <int D>
bool areKeptApart(const State<D>& state)
{
  return state.particles.has(fields::bodyGroup);
}

/// Each pair in both orders. \param scene validated; its section Bodies is read
inline std::set<std::pair<std::string, std::string>> bondedPairs(const Teuchos::ParameterList& scene)
{
  std::set<std::pair<std::string, std::string>> pairs;
  const Teuchos::ParameterList& section = scene.sublist("Bodies");
  for (auto entry = section.begin(); entry != section.end(); ++entry)
  {
    const auto* const body = valueIf<Teuchos::ParameterList>(section.entry(entry));
    const auto* const given = body != nullptr ? valueIf<std::string>(*body, "Bonded To") : nullptr;
    if (given == nullptr)
      continue;
    std::istringstream names(*given);
    for (std::string name; std::getline(names, name, ',');)
    {
      pairs.emplace(section.name(entry), trimmed(name));
      pairs.emplace(trimmed(name), section.name(entry));
    }
  }
  return pairs;
}

} // namespace Rhegma
