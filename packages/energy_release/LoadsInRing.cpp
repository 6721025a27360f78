#include "energy_release/LoadsInRing.hpp"

#include "scene/ReadList.hpp"
#include "scene/ShortNumber.hpp"
#include "transfer/LocalSpacing.hpp"

#include <algorithm>

namespace Rhegma::energy_release
{

std::vector<PlacedLoad> readLoads(const Teuchos::ParameterList& scene)
{
  std::vector<PlacedLoad> loads;
  if (!scene.isSublist("Boundaries"))
    return loads;
  const Teuchos::ParameterList& boundaries = scene.sublist("Boundaries");
  for (const std::string& name : sublistNames(boundaries))
  {
    const Teuchos::ParameterList& one = boundaries.sublist(name);
    const auto type = one.get<std::string>("Type");
    if (type == "Point Load")
      loads.push_back({name, readVector<2>(one, "Point"), readVector<2>(one, "Point")});
    else if (type == "Line Load")
      loads.push_back({name, readVector<2>(one, "From"), readVector<2>(one, "To")});
  }
  return loads;
}

void warnOfLoads(State<2>& state, const CrackFront<2>& front, const ContourRadii& radii,
                 const std::vector<PlacedLoad>& loads)
{
  const double cell = spacingAt(state, front.position);
  for (const PlacedLoad& load : loads)
  {
    const Vector<2> along = load.to - load.from, to = front.position - load.from;
    const double square = dot(along, along);
    const double at = square > 0.0 ? std::clamp(dot(to, along) / square, 0.0, 1.0) : 0.0;
    const double nearest = norm(to - at * along), furthest = std::max(norm(to), norm(to - along));
    if (nearest > radii.outer + cell || furthest < radii.inner - cell)
      continue;
    state.warnings.push_back("Energy Release: Boundaries > " + load.name + " acts in the ring from " +
                             shortly(radii.inner) + " to " + shortly(radii.outer) + " m round the front " +
                             state.cracks.cracks[front.crack].name + "." + std::to_string(front.number) +
                             ", where cells don't resolve the stress beside it and G_J can be off by 10 %; "
                             "choose radii (Inner Radius, Outer Radius) with the load clear of the ring by a "
                             "cell");
  }
}

} // namespace Rhegma::energy_release
