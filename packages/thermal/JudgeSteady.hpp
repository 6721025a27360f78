#pragma once
/// Bodies whose temperature steady conduction does not determine
/// (docs/reference/warnings-of-cracks-and-runs.md).

#include "base/ReadList.hpp"
#include "base/ShortNumber.hpp"
#include "boundary/BodySurface.hpp"
#include "plausibility/BodyGroups.hpp"
#include "thermal/Conduction.hpp"

#include <map>

namespace Rhegma::thermal
{

/// The power of all sources at the end of the run in each body, as sources give it to particles [W].
template <int D>
std::vector<double> powerOfBodies(const Conduction<D>& conduction, double end, std::size_t bodies,
                                  const State<D>& state)
{
  View<double*> supply("power of particles", state.particles.size());
  for (const Source<D>& source : conduction.sources)
    addSource(state, source, end, 0.0, supply);
  const auto ofParticle = onHost(supply);
  const auto body = onHost(state.particles.integer(fields::body));
  std::vector<double> power(bodies, 0.0);
  for (int p = 0; p < state.particles.size(); ++p)
    power[body(p)] += ofParticle(p);
  return power;
}

/// Warns of bodies that no prescribed temperature and no convection reaches, with the heat that flows into
/// them. Bodies whose bounds come within two cells count as one. \param scene its core and Thermal \param end
/// of the run [s]
template <int D>
void judgeSteady(const Teuchos::ParameterList& scene, const Conduction<D>& conduction, double end,
                 State<D>& state)
{
  const std::vector<BodyMeasure<D>> bodies = measureBodies(state);
  if (bodies.size() < 2 || !scene.isSublist("Boundaries")) // else an error, where there is none
    return;
  const double cell = state.mesh.grid.spacing;
  BodyGroups<D> groups(bodies, cell);
  std::map<std::string, int> groupOf;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    groupOf[bodies[b].name] = groups.of(static_cast<int>(b));
  std::vector<char> determined(groups.count(), 0);
  std::vector<double> heat(groups.count(), 0.0);
  const Teuchos::ParameterList& section = scene.sublist("Boundaries");
  for (const std::string& name : sublistNames(section))
  {
    const Teuchos::ParameterList& list = section.sublist(name);
    const std::string type = list.get<std::string>("Type");
    if (type == "Temperature")
      for (const int body :
           groups.near({readVector<D>(list, "Lower Corner"), readVector<D>(list, "Upper Corner")}, cell))
        determined[groups.of(body)] = 1;
    else if (type == "Convection")
      determined[groupOf.at(list.get<std::string>("Body"))] = 1;
    else if (type == "Heat Flux")
      heat[groupOf.at(list.get<std::string>("Body"))] +=
          list.get<double>("Flux") * measureSurface<D>(scene, list, "Boundaries > " + name).area *
          TimeFunction::parse(list.get<std::string>("History"))(end);
  }
  const std::vector<double> power = powerOfBodies(conduction, end, state.bodies.info.size(), state);
  for (std::size_t b = 0; b < state.bodies.info.size(); ++b)
    if (const auto group = groupOf.find(state.bodies.info[b].name); group != groupOf.end())
      heat[group->second] += power[b];
  for (int g = 0; g < groups.count(); ++g)
  {
    if (determined[g] != 0)
      continue;
    state.warnings.push_back(
        "Thermal > Conduction: no Temperature and no Convection (Boundaries) reaches Bodies > " +
        bodies[groups[g].bodies.front()].name + ", so that its steady temperature is not determined" +
        (heat[g] != 0.0 ? ", and " + formatShort(heat[g]) + " W flow into it that nothing takes away"
                        : ": it keeps that of the start") +
        "; prescribe a temperature of it, or write Conduction = Implicit" +
        (state.method.analysis == Analysis::Static ? " and Time > Analysis = Quasi-Static" : ""));
  }
}

} // namespace Rhegma::thermal
