#include "scene/CrackNames.hpp"

#include "base/ReadList.hpp"

namespace Rhegma
{

std::string joined(const std::vector<std::string>& names)
{
  std::string all;
  for (const std::string& name : names)
    all += (all.empty() ? "" : ", ") + name;
  return all;
}

bool checkCrackNames(const Teuchos::ParameterList& scene, const std::string& section,
                     const std::string& could, std::vector<SceneError>& errors)
{
  if (!scene.isSublist("Cracks"))
  {
    errors.push_back({section, "there are no crack faces that " + could + "; add a section Cracks or leave " +
                                   section + " out"});
    return false;
  }
  const Teuchos::ParameterList& cracks = scene.sublist("Cracks");
  for (const std::string& name : sublistNames(scene.sublist(section)))
    if (!cracks.isSublist(name))
      errors.push_back({section + " > " + name,
                        "there is no crack of this name; Cracks has " + joined(sublistNames(cracks))});
  return true;
}

} // namespace Rhegma
