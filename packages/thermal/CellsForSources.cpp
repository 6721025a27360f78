#include "thermal/CellsForSources.hpp"

#include "base/ReadList.hpp"
#include "scene/SceneBodies.hpp"
#include "scene/Validation.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::thermal
{

namespace
{

/// Whether any of a disk or ball lies in a body at some time of the run: checked at its centre and on rings
/// of half and full radius, every half radius of its path.
template <int D>
bool meetsMaterial(const Teuchos::ParameterList& source, const Teuchos::ParameterList& scene)
{
  const SceneBodies<D> bodies(scene);
  const Vector<D> centre = readVector<D>(source, "Centre"), velocity = readVector<D>(source, "Velocity");
  const double radius = source.get<double>("Radius");
  const double path = norm(velocity) * scene.sublist("Time").get<double>("Final Time");
  constexpr double most = 1e5; // largest number of positions along the path
  const int steps = static_cast<int>(std::min(most, std::ceil(path / (0.5 * radius))));
  for (int k = 0; k <= steps; ++k)
  {
    const double along = steps > 0 ? path * k / steps / norm(velocity) : 0.0; // [s]
    const Vector<D> middle = centre + along * velocity;
    if (bodies.contain(middle))
      return true;
    for (const double fraction : {0.5, 1.0})
      for (int d = 0; d < D; ++d)
        for (const double sign : {-1.0, 1.0})
        {
          Vector<D> position = middle;
          position[d] += sign * fraction * radius;
          if (bodies.contain(position))
            return true;
        }
  }
  return false;
}

} // namespace

void reportCells(const Teuchos::ParameterList& scene, CellNeeds& needs, std::vector<SceneError>& errors)
{
  needs.facesLoaded = needs.heat = true;
  if (!scene.sublist("Thermal").isSublist("Sources"))
    return;
  const Teuchos::ParameterList& sources = scene.sublist("Thermal").sublist("Sources");
  for (const std::string& name : sublistNames(sources))
  {
    const Teuchos::ParameterList& source = sources.sublist(name);
    if (!source.isType<double>("Radius"))
      continue;
    const std::string where = "Thermal > Sources > " + name;
    if (!(dimensionOf(scene) == 2 ? meetsMaterial<2>(source, scene) : meetsMaterial<3>(source, scene)))
      errors.push_back({where + " > Centre",
                        "it meets no body during the run, so Domain > Accuracy can't choose cells "
                        "for it; correct Centre or Velocity, or write Cell Size"});
    const double radius = source.get<double>("Radius");
    if (radius < std::min(needs.source, needs.atRest))
      needs.smallestSource = where;
    const bool moves = dimensionOf(scene) == 2 ? norm(readVector<2>(source, "Velocity")) > 0.0
                                               : norm(readVector<3>(source, "Velocity")) > 0.0;
    double& smallest = moves ? needs.source : needs.atRest;
    smallest = std::min(smallest, radius);
  }
}

} // namespace Rhegma::thermal
