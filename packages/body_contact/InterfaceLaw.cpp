#include "body_contact/InterfaceLaw.hpp"

#include "base/ReadList.hpp"
#include "scene/FrictionSection.hpp"

#include <algorithm>

namespace Rhegma::body_contact
{

namespace
{

const char* const normalStiffness = "Normal Stiffness";
const char* const alongStiffness = "Tangential Stiffness";

bool hasLaw(const Teuchos::ParameterList& list)
{
  return list.isType<std::string>("Law") && list.get<std::string>("Law") == interfaceLaw;
}

} // namespace

void addInterfaceLawOfList(Section& pair)
{
  addFrictionLawOfList(
      pair,
      {{interfaceLaw, "Interface: the faces that touch at the start stay joined by springs, an imperfect "
                      "bond; elsewhere the two bodies have the law of the section."}});
  pair.real(normalStiffness)
      .unit("Pa/m")
      .notNegative()
      .optional()
      .meaning(
          "Traction over displacement jump along the normal of the faces, for Law = Interface. A layer of "
          "thickness h and modulus E has about E / h.");
  pair.real(alongStiffness)
      .unit("Pa/m")
      .notNegative()
      .optional()
      .meaning("The same along the faces: for a layer of shear modulus G about G / h.");
}

void checkInterfaceLaw(const Teuchos::ParameterList& list, const std::string& path,
                       std::vector<SceneError>& errors)
{
  for (const char* const name : {normalStiffness, alongStiffness})
  {
    const std::string where = path + " > " + name;
    const bool refused = std::any_of(errors.begin(), errors.end(),
                                     [&](const SceneError& error) { return error.where == where; });
    if (hasLaw(list) && !list.isParameter(name) && !refused)
      errors.push_back({where, "is missing; Law = Interface needs it: write, for example, 1e12"});
    if (!hasLaw(list) && list.isParameter(name))
      errors.push_back({where, "is a stiffness of Law = Interface; write that law or leave it out"});
  }
}

std::optional<InterfaceLaw> interfaceLawIf(const Teuchos::ParameterList& list)
{
  if (!hasLaw(list))
    return std::nullopt;
  return InterfaceLaw{list.get<double>(normalStiffness), list.get<double>(alongStiffness)};
}

bool hasInterfaces(const Teuchos::ParameterList& section)
{
  const std::vector<std::string> names = sublistNames(section);
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& name) { return hasLaw(section.sublist(name)); });
}

} // namespace Rhegma::body_contact
