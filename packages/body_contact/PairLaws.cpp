#include "body_contact/PairLaws.hpp"

#include "base/ReadList.hpp"
#include "scene/FrictionSection.hpp"

#include <algorithm>
#include <map>

namespace Rhegma::body_contact
{

namespace
{

/// The groups of a pair's bodies, in their order in the list; below 0 where a name is unknown.
std::pair<int, int> groupsOf(const std::string& bodies, const BondedGroups& groups,
                             const std::vector<std::string>& names)
{
  std::vector<int> found;
  for (const std::string& name : splitNames(bodies))
  {
    const auto body = std::find(names.begin(), names.end(), name);
    found.push_back(body == names.end() ? -1 : groups.of[body - names.begin()]);
  }
  found.resize(2, -1);
  return {found[0], found[1]};
}

} // namespace

void checkLaws(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors)
{
  const Teuchos::ParameterList& section = scene.sublist("Body Contact");
  checkFrictionLaw(section, "Body Contact", errors);
  if (!scene.isSublist("Bodies"))
    return;
  const Teuchos::ParameterList& bodies = scene.sublist("Bodies");
  const std::vector<std::string> names = sublistNames(bodies);
  for (const std::string& name : names)
  {
    const auto* const bonded = valueIf<std::string>(bodies.sublist(name), "Bonded To");
    for (const std::string& other : bonded != nullptr ? splitNames(*bonded) : std::vector<std::string>{})
      if (std::find(names.begin(), names.end(), other) == names.end())
        errors.push_back({"Bodies > " + name + " > Bonded To",
                          "there is no body \"" + other +
                              "\", so the two would be in contact instead; write the name of a body"});
  }
  const BondedGroups groups = bondedGroups(bodies, names);
  std::map<std::pair<int, int>, std::string> before;
  for (const std::string& pair : sublistNames(section))
  {
    const std::string path = "Body Contact > " + pair;
    const Teuchos::ParameterList& list = section.sublist(pair);
    checkFrictionLaw(list, path, errors);
    checkInterfaceLaw(list, path, errors);
    const auto* const text = valueIf<std::string>(list, "Bodies");
    if (text == nullptr)
      continue;
    const std::vector<std::string> given = splitNames(*text);
    bool known = given.size() == 2;
    if (!known)
      errors.push_back({path + " > Bodies", "write the names of two bodies with a comma between them"});
    for (const std::string& name : given)
      if (std::find(names.begin(), names.end(), name) == names.end())
      {
        known = false;
        errors.push_back({path + " > Bodies", "there is no body \"" + name + "\"; write the name of a body"});
      }
    if (!known)
      continue;
    const auto listed = groupsOf(*text, groups, names);
    const std::pair<int, int> of = std::minmax(listed.first, listed.second);
    if (of.first == of.second)
      errors.push_back({path + " > Bodies",
                        "the two are one body or bonded (Bonded To), so they are never in "
                        "contact; remove this list or the bond"});
    else if (const auto [first, added] = before.emplace(of, pair); !added)
      errors.push_back(
          {path + " > Bodies", "Body Contact > " + first->second +
                                   " is about the same bodies, or bodies bonded to them; keep one"});
  }
}

std::vector<NamedPair> namedPairs(const Teuchos::ParameterList& section, const BondedGroups& groups,
                                  const std::vector<std::string>& names)
{
  std::vector<NamedPair> pairs;
  for (const std::string& name : sublistNames(section))
  {
    const auto of = groupsOf(section.sublist(name).get<std::string>("Bodies"), groups, names);
    pairs.push_back({name, std::min(of.first, of.second), std::max(of.first, of.second), of.first > of.second,
                     interfaceLawIf(section.sublist(name))});
  }
  return pairs;
}

PairLaws readLaws(const Teuchos::ParameterList& section, const std::vector<NamedPair>& pairs, int groups)
{
  PairLaws laws{groups, readFrictionLaw(section), {}};
  if (pairs.empty())
    return laws;
  laws.ofGroups = View<FrictionLaw**>("rhegma::lawsOfPairs", groups, groups);
  const auto host = Kokkos::create_mirror_view(laws.ofGroups);
  for (int a = 0; a < groups; ++a)
    for (int b = 0; b < groups; ++b)
      host(a, b) = laws.others;
  for (const NamedPair& pair : pairs)
    if (section.sublist(pair.name).isParameter("Law") && !pair.interface)
      host(pair.one, pair.other) = host(pair.other, pair.one) = readFrictionLaw(section.sublist(pair.name));
  Kokkos::deep_copy(laws.ofGroups, host);
  return laws;
}

} // namespace Rhegma::body_contact
