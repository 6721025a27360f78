#include "scene/FrictionSection.hpp"

#include <algorithm>
#include <limits>

namespace Rhegma
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

void addFrictionLaw(Section& s)
{
  s.choice("Law", lawNames).byDefault("Frictionless").meaning(meaningOfLaw);
  addFriction(s);
}

void addFrictionLawOfList(Section& s, const std::vector<OtherLaw>& more)
{
  std::vector<std::string> names = lawNames;
  std::string meaning = meaningOfLaw;
  for (const OtherLaw& law : more)
  {
    names.push_back(law.name);
    meaning += " " + law.meaning;
  }
  s.choice("Law", names).optional("that of the section").meaning(meaning);
  addFriction(s);
}

void checkFrictionLaw(const Teuchos::ParameterList& list, const std::string& path,
                      std::vector<SceneError>& errors)
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

FrictionLaw readFrictionLaw(const Teuchos::ParameterList& list)
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

} // namespace Rhegma
