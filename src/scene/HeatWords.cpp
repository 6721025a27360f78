#include "scene/HeatWords.hpp"

#include "base/ReadList.hpp"
#include "material/ThermoMaterials.hpp"

namespace Rhegma
{

namespace
{

const std::string add = "; add the section Thermal or leave it out";

std::string text(const Teuchos::ParameterList& list, const std::string& name)
{
  return list.isType<std::string>(name) ? list.get<std::string>(name) : std::string();
}

void refuseInMaterial(const Teuchos::ParameterList& list, const std::string& where,
                      std::vector<SceneError>& errors)
{
  if (!tableTemperatures(list).empty())
    errors.push_back({where, "it is a table of temperature, but the scene has no section Thermal" + add});
  if (text(list, "Model") == "Rigid")
    errors.push_back({where + " > Model", "Rigid is for scenes with heat only; choose a law with stress, or "
                                          "add Thermal with Mechanics = false"});
}

void refuseInBody(const Teuchos::ParameterList& list, const std::string& where,
                  std::vector<SceneError>& errors)
{
  for (const char* name : {"Temperature", "Temperature Field"})
    if (list.isParameter(name))
      errors.push_back({where + " > " + name, "the scene has no section Thermal" + add});
}

} // namespace

void refuseHeatWords(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors)
{
  if (scene.isSublist("Thermal"))
    return;
  const auto inAll = [&](const char* section, const auto& refuse)
  {
    if (!scene.isSublist(section))
      return;
    const Teuchos::ParameterList& list = scene.sublist(section);
    for (const std::string& name : sublistNames(list))
      refuse(list.sublist(name), std::string(section).append(" > ").append(name), errors);
  };
  inAll("Materials", refuseInMaterial);
  inAll("Bodies", refuseInBody);
}

} // namespace Rhegma
