#include "body_contact/PairLaws.hpp"

#include "base/ReadList.hpp"

#include <algorithm>
#include <limits>
#include <map>

namespace Rhegma::body_contact
{

namespace
{

const std::vector<std::string> lawNames = {"Frictionless", "Coulomb", "Stick"};
const char* const meaningOfLaw = "How bodies that press on each other move along each other: freely, with "
                                 "Coulomb friction, or not at all. "
                                 "In each case they can separate.";

void addFriction(Section& s)
{
  s.real("Friction Coefficient").notNegative().optional().meaning("Friction coefficient of Law = Coulomb.");
  s.real("Static Friction Coefficient")
      .notNegative()
      .optional("Friction Coefficient")
      .meaning("Friction coefficient up to which bodies with Law = Coulomb do not start to slide.");
}

} // namespace

void addLawParameters(Section& s)
{
  s.choice("Law", lawNames).byDefault("Frictionless").meaning(meaningOfLaw);
  addFriction(s);
}

void addLawParametersOfPair(Section& s)
{
  s.choice("Law", lawNames).optional("that of the section").meaning(meaningOfLaw);
  addFriction(s);
}

namespace
{

void checkLaw(const Teuchos::ParameterList& list, const std::string& path, std::vector<SceneError>& errors)
{
  const char* const name = "Friction Coefficient";
  const char* const atRest = "Static Friction Coefficient";
  if (!list.isType<std::string>("Law"))
  {
    for (const char* const given : {name, atRest})
      if (list.isParameter(given) && !list.isParameter("Law"))
        errors.push_back({path + " > " + given, "is given without Law; write Law = Coulomb too"});
    return;
  }
  const auto law = list.get<std::string>("Law");
  if (law != "Coulomb")
  {
    for (const char* const given : {name, atRest})
      if (list.isParameter(given))
        errors.push_back(
            {path + " > " + given, "the law " + law +
                                       " has no friction coefficient; leave it out or choose Law = "
                                       "Coulomb"});
    return;
  }
  const std::string coefficient = path + " > " + name;
  const bool refused = std::any_of(errors.begin(), errors.end(),
                                   [&](const SceneError& error) { return error.where == coefficient; });
  if (!list.isParameter(name) && !refused)
    errors.push_back({coefficient,
                      "is missing; Law = Coulomb needs it: write, for example, 0.3, or choose Law = "
                      "Frictionless"});
  else if (list.isType<double>(atRest) && list.isType<double>(name) &&
           list.get<double>(atRest) < list.get<double>(name))
    errors.push_back(
        {path + " > " + atRest,
         "is smaller than Friction Coefficient; a body would slide as soon as it sticks: write a "
         "larger one or leave it out"});
}

PairLaw readLaw(const Teuchos::ParameterList& list)
{
  const auto law = list.get<std::string>("Law");
  if (law == "Frictionless")
    return {};
  if (law == "Stick")
    return {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  const auto sliding = list.get<double>("Friction Coefficient");
  const char* const atRest = "Static Friction Coefficient";
  return {list.isParameter(atRest) ? list.get<double>(atRest) : sliding, sliding};
}

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
  checkLaw(section, "Body Contact", errors);
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
    checkLaw(list, path, errors);
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
    pairs.push_back(
        {name, std::min(of.first, of.second), std::max(of.first, of.second), of.first > of.second});
  }
  return pairs;
}

PairLaws readLaws(const Teuchos::ParameterList& section, const std::vector<NamedPair>& pairs, int groups)
{
  PairLaws laws{readLaw(section), {}};
  if (pairs.empty())
    return laws;
  laws.ofGroups = View<PairLaw**>("rhegma::lawsOfPairs", groups, groups);
  const auto host = Kokkos::create_mirror_view(laws.ofGroups);
  for (int a = 0; a < groups; ++a)
    for (int b = 0; b < groups; ++b)
      host(a, b) = laws.others;
  for (const NamedPair& pair : pairs)
    if (section.sublist(pair.name).isParameter("Law"))
      host(pair.one, pair.other) = host(pair.other, pair.one) = readLaw(section.sublist(pair.name));
  Kokkos::deep_copy(laws.ofGroups, host);
  return laws;
}

} // namespace Rhegma::body_contact
