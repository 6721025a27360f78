#include "boundary/SurfaceReport.hpp"

#include "base/ReadList.hpp"
#include "boundary/BodySurface.hpp"
#include "plan/Axis.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace Rhegma
{

namespace
{

/// Points that pictures show of a surface.
constexpr std::size_t shown = 48;

template <int D>
std::vector<double> asList(const Vector<D>& x)
{
  return std::vector<double>(x.c, x.c + D);
}

} // namespace

template <int D>
nlohmann::json surfacesOf(const Teuchos::ParameterList& scene)
{
  nlohmann::json surfaces = nlohmann::json::array();
  if (!scene.isSublist("Boundaries"))
    return surfaces;
  const Teuchos::ParameterList& section = scene.sublist("Boundaries");
  const Depth depth = depthOf<D>(scene);
  for (const std::string& name : sublistNames(section))
  {
    const Teuchos::ParameterList& list = section.sublist(name);
    if (!choosesSurface(list))
      continue;
    const auto points = chosenSurface<D>(scene, list, "Boundaries > " + name);
    nlohmann::json entry = {{"name", name},
                            {"body", list.get<std::string>("Body")},
                            {"area", measureSurface(points, depth).area}};
    const std::size_t count = std::min(points.size(), shown);
    for (std::size_t k = 0; k < count; ++k)
    {
      // Steps by the golden section do not fall in step with the rows in which points lie.
      constexpr double golden = 0.6180339887498949;
      const double at = count < points.size() ? std::fmod((k + 0.5) * golden, 1.0) : (k + 0.5) / count;
      const Geometry::SurfacePoint<D>& point = points[static_cast<std::size_t>(at * points.size())];
      entry["points"].push_back(asList(point.x));
      entry["normals"].push_back(asList(point.normal));
    }
    surfaces.push_back(entry);
  }
  return surfaces;
}

template nlohmann::json surfacesOf<2>(const Teuchos::ParameterList&);
template nlohmann::json surfacesOf<3>(const Teuchos::ParameterList&);

} // namespace Rhegma
