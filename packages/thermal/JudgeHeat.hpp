#pragma once
/// Whether the heat of a scene reaches its bodies (docs/reference/warnings-of-cracks-and-runs.md).

#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "base/ShortNumber.hpp"
#include "boundary/TouchedNodes.hpp"
#include "material/TemperatureTable.hpp"
#include "plausibility/IdleLoads.hpp"
#include "thermal/Conduction.hpp"
#include "thermal/JudgeHistories.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Rhegma::thermal
{

/// Above all boiling points of solids (rhenium 5900 K) [K].
constexpr double hottest = 6000.0;

/// Distance of a position from a box [m].
template <int D>
double distanceToBox(const Vector<D>& x, const Vector<D>& lower, const Vector<D>& upper)
{
  Vector<D> off;
  for (int d = 0; d < D; ++d)
    off[d] = std::max({0.0, lower[d] - x[d], x[d] - upper[d]});
  return norm(off);
}

/// Distance of a position from the straight path between two others [m].
template <int D>
double distanceToPath(const Vector<D>& x, const Vector<D>& from, const Vector<D>& along)
{
  const double square = dot(along, along);
  const double part = square > 0.0 ? std::clamp(dot(x - from, along) / square, 0.0, 1.0) : 0.0;
  return norm(x - from - part * along);
}

/// Smallest distance of a source from the nodes of bodies at any time of the run [m].
template <int D>
double distanceOf(const Source<D>& source, double end, const std::vector<Vector<D>>& nodes)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vector<D>& x : nodes)
    nearest = std::min(nearest, source.ball
                                    ? distanceToPath(x, source.centre, end * source.velocity) - source.radius
                                    : distanceToBox(x, source.lower, source.upper));
  return nearest;
}

/// Warns of sources of no power, and of probes off the bodies, which report what is extrapolated.
/// \param list section Thermal \param nodes of bodies
template <int D>
void judgeSourcesAndProbes(const Teuchos::ParameterList& list, double end, double cell,
                           const std::vector<Vector<D>>& nodes, std::vector<std::string>& warnings)
{
  const Teuchos::ParameterList none;
  const Teuchos::ParameterList& sources = list.isSublist("Sources") ? list.sublist("Sources") : none;
  for (const std::string& name : sublistNames(sources))
    for (const std::string& message : idleMessages({"Thermal > Sources > " + name, "source"},
                                                   sources.sublist(name), {"Power", "Power Density"}, {end}))
      warnings.push_back(message);
  const Teuchos::ParameterList& probes = list.isSublist("Probes") ? list.sublist("Probes") : none;
  for (const std::string& name : sublistNames(probes))
  {
    const Vector<D> x = readVector<D>(probes.sublist(name), "Point");
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vector<D>& node : nodes)
      nearest = std::min(nearest, norm(x - node));
    // A node of its cell is no farther from a point than half of the diagonal.
    if (nearest > (0.5 + 1e-6) * std::sqrt(double(D)) * cell)
      warnings.push_back("Thermal > Probes > " + name + " > Point: no body is closer than " +
                         readableLength(nearest) +
                         ", so it reports what is extrapolated from the nearest particle; move it into a "
                         "body");
  }
}

/// Warns of materials that conduct heat as no solid does. Pyrolytic graphite and diamond conduct best (1.2e-3
/// m2/s), polymers worst (5e-8 m2/s). Of a table its first value counts. \param materials section Materials
inline void judgeDiffusivities(const Teuchos::ParameterList& materials, std::vector<std::string>& warnings)
{
  constexpr double least = 1e-9, most = 2e-3; // [m2/s]
  const auto firstOf = [](const Teuchos::ParameterList& list, const char* name)
  {
    return list.isType<double>(name) ? list.get<double>(name)
           : list.isType<std::string>(name)
               ? TemperatureTable::parse(list.get<std::string>(name)).value.front()
               : 0.0;
  };
  for (const std::string& name : sublistNames(materials))
  {
    const Teuchos::ParameterList& list = materials.sublist(name);
    const double conductivity = firstOf(list, "Conductivity"), heat = firstOf(list, "Specific Heat");
    const double diffusivity = conductivity / (list.get<double>("Density") * heat);
    if (!(conductivity > 0.0) || !(heat > 0.0) || (diffusivity >= least && diffusivity <= most))
      continue;
    warnings.push_back("Materials > " + name + ": its thermal diffusivity, Conductivity over Density and " +
                       "Specific Heat, is " + formatShort(diffusivity) + " m2/s, " +
                       (diffusivity > most ? "more than of any solid at 293 K (graphite 1.2e-3)"
                                           : "less than of any solid (polymers 5e-8)") +
                       "; check units (W/(m K), kg/m3, J/(kg K)), or write a Conductivity of zero if it "
                       "does not matter");
  }
}

/// Warns of held temperatures and sources that no body touches, of temperatures no solid has, of a run too
/// short for heat to leave a particle, and of a diffusivity that no solid has.
/// \param scene its core and Thermal \param end of the run [s]
template <int D>
void judgeHeat(const Teuchos::ParameterList& scene, const Conduction<D>& conduction, double end,
               State<D>& state)
{
  const std::vector<Vector<D>> nodes = touchedNodes(state);
  const double cell = state.mesh.grid.spacing;
  Teuchos::ParameterList none;
  const Teuchos::ParameterList& boundaries =
      scene.isSublist("Boundaries") ? scene.sublist("Boundaries") : none;
  for (const std::string& name : sublistNames(boundaries))
  {
    const Teuchos::ParameterList& list = boundaries.sublist(name);
    const std::string where = "Boundaries > " + name;
    for (const char* value : {"Temperature", "Ambient Temperature"})
      if (list.isType<double>(value) && list.get<double>(value) > hottest)
        state.warnings.push_back(where + " > " + value + " is " + formatShort(list.get<double>(value)) +
                                 " K, at which no solid exists; check the exponent");
    if (list.get<std::string>("Type") != "Temperature")
      continue;
    const Vector<D> lower = readVector<D>(list, "Lower Corner"), upper = readVector<D>(list, "Upper Corner");
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vector<D>& x : nodes)
      nearest = std::min(nearest, distanceToBox(x, lower, upper));
    if (nearest > 1e-6 * cell)
      state.warnings.push_back(where + ": it contains no node of any body; the nearest is " +
                               readableLength(nearest) + " away; move it to the body");
  }
  judgeSourcesAndProbes<D>(scene.sublist("Thermal"), end, cell, nodes, state.warnings);
  judgeShortPulses(scene, conduction, end, state);
  judgeHeldInSteps(scene, state);
  for (const Source<D>& source : conduction.sources)
    if (const double nearest = distanceOf(source, end, nodes); nearest > cell)
      state.warnings.push_back("Thermal > Sources > " + source.name + ": no body comes closer than " +
                               readableLength(nearest) + ", so it heats nothing; move it to the body");
  judgeDiffusivities(scene.sublist("Materials"), state.warnings);
  const double diffusivity = conduction.diffusivity;
  const double reach = std::sqrt(diffusivity * end);
  if (!state.method.mechanics && diffusivity > 0.0 && reach < 0.1 * state.mesh.smallestSpacing())
    state.warnings.push_back(
        "Time > Final Time is " + readableTime(end) + ", in which heat spreads by " + readableLength(reach) +
        ", " + formatShort(reach / state.mesh.smallestSpacing()) + " cells of " +
        readableLength(state.mesh.smallestSpacing()) + "; are lengths in metres, and the time in seconds?");
}

} // namespace Rhegma::thermal
