#include "plan/BoundaryType.hpp"

#include "base/ReadList.hpp"

#include <algorithm>
#include <stdexcept>

namespace Rhegma
{

namespace
{

std::vector<BoundaryType>& all()
{
  static std::vector<BoundaryType> types = builtInBoundaryTypes();
  return types;
}

const BoundaryType* find(const std::string& name)
{
  const auto found = std::find_if(all().begin(), all().end(),
                                  [&](const BoundaryType& type) { return type.section.name == name; });
  return found == all().end() ? nullptr : &*found;
}

} // namespace

void addBoundaryType(BoundaryType type)
{
  const std::string start = "the boundary type \"" + type.section.name + "\" can't be added: ";
  if (find(type.section.name) != nullptr)
    throw std::invalid_argument(start + "a type of this name is there");
  if (type.capability.empty() && (!type.add2 || !type.add3))
    throw std::invalid_argument(start + "set what it does in 2D and in 3D");
  all().push_back(std::move(type));
}

const std::vector<BoundaryType>& boundaryTypes() { return all(); }

const BoundaryType& boundaryType(const std::string& name)
{
  if (const BoundaryType* type = find(name))
    return *type;
  throw std::invalid_argument("there is no boundary type \"" + name + "\"");
}

std::vector<BoundaryRegion> boundaryRegions(const Teuchos::ParameterList& scene)
{
  std::vector<BoundaryRegion> regions;
  if (scene.isSublist("Boundaries"))
    for (const std::string& name : sublistNames(scene.sublist("Boundaries")))
    {
      const Teuchos::ParameterList& list = scene.sublist("Boundaries").sublist(name);
      if (const BoundaryType& type = boundaryType(list.get<std::string>("Type")); type.region)
      {
        regions.push_back(type.region(list));
        regions.back().name = name;
      }
    }
  return regions;
}

void checkBoundaries(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors)
{
  SectionChecks checks(scene, errors);
  checks.forEach("Boundaries",
                 [&](const Teuchos::ParameterList& list, const std::string& where)
                 {
                   const BoundaryType* type = find(SceneValues::text(list, "Type"));
                   checks.named(list, "Body", "Bodies", where);
                   checks.history(list, where);
                   if (type != nullptr && type->check)
                     type->check(checks, list, where);
                 });
}

} // namespace Rhegma
