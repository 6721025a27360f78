#include "boundary/MirrorPlanes.hpp"

#include "base/ReadList.hpp"

#include <string>

namespace Rhegma
{

std::vector<MirrorPlane> mirrorPlanes(const Teuchos::ParameterList& scene)
{
  std::vector<MirrorPlane> planes;
  if (!scene.isSublist("Boundaries"))
    return planes;
  const Teuchos::ParameterList& all = scene.sublist("Boundaries");
  for (const std::string& name : sublistNames(all))
  {
    const Teuchos::ParameterList& one = all.sublist(name);
    if (one.get<std::string>("Type") == "Symmetry")
      planes.push_back({one.get<std::string>("Axis")[0] - 'x', one.get<double>("Position")});
  }
  return planes;
}

} // namespace Rhegma
