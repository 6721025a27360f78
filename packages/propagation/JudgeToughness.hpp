#pragma once
/// Whether a toughness fits the loads, the material and the body (docs/plausibility.md).

#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "plausibility/LoadEstimate.hpp"
#include "propagation/Options.hpp"
#include "propagation/RayleighSpeed.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::propagation
{

/// Longest extent of a crack along an axis [m], as it lies in the bodies.
template <int D>
double extentOf(const State<D>& state, const Crack<D>& crack)
{
  const auto x = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.cracks.vertex);
  double longest = 0.0;
  for (int d = 0; d < D; ++d)
  {
    double low = x(crack.firstVertex, d), high = low;
    for (int v = crack.firstVertex; v < crack.firstVertex + crack.numVertices; ++v)
    {
      low = std::min(low, x(v, d));
      high = std::max(high, x(v, d));
    }
    longest = std::max(longest, high - low);
  }
  return longest;
}

/// Warns of a Speed Limit with which no front can advance by a cell. \param scene its core
template <int D>
void judgeSpeedLimit(const Teuchos::ParameterList& scene, const Options& options, State<D>& state)
{
  const double time = scene.sublist("Time").get<double>("Final Time") - options.rule.startTime;
  const double length = options.speedLimit * time, cell = state.mesh.smallestSpacing();
  if (options.speedLimit > 0.0 && time > 0.0 && length < cell)
    state.warnings.push_back("Propagation > Speed Limit is " + formatReal(options.speedLimit) +
                             " m/s: a front advances by " + readableLength(length) +
                             " at most up to Time > Final Time, and a cell has " + readableLength(cell) +
                             "; no crack grows: write a larger limit (m/s), or leave it out");
}

/// Compares the loads' stress with that of Griffith, sqrt(E' Gc / (pi a)), and the toughness with what the
/// bonds of any solid take and what a linear law can carry. Margins are wide, as the loads' stress is
/// nominal. \param scene its core \param run what other effects declare
template <int D>
void judgeToughness(const Teuchos::ParameterList& scene, const RunOptions& run, const Options& options,
                    State<D>& state)
{
  constexpr double pi = 3.14159265358979, margin = 8.0, mostStrain = 0.05;
  if (state.cracks.cracks.empty() || state.bodies.info.empty())
    return;
  judgeSpeedLimit(scene, options, state);
  const std::vector<BodyMeasure<D>> bodies = measureBodies(state);
  const std::vector<LoadEstimate> loads = estimateLoads(scene, state, bodies);
  double longest = 0.0;
  for (const Crack<D>& crack : state.cracks.cracks)
    longest = std::max(longest, extentOf(state, crack));
  const auto by = [](const auto& a, const auto& b)
  { return a.moduli.effectiveModulus < b.moduli.effectiveModulus; };
  const BodyMeasure<D>& soft = *std::min_element(bodies.begin(), bodies.end(), by);
  const BodyMeasure<D>& stiff = *std::max_element(bodies.begin(), bodies.end(), by);
  const double atRest = std::max(options.rule.initiation, options.rule.toughness(0.0, options.temperature));
  double most = atRest;
  for (const Properties& material : state.materials.properties)
    for (int k = 1; k <= 20; ++k)
      most = std::max(most, options.rule.toughness(0.05 * k * rayleighSpeed(material), options.temperature));
  const auto griffith = [&](const BodyMeasure<D>& body, double toughness)
  { return std::sqrt(body.moduli.effectiveModulus * toughness / (pi * longest)); };
  const std::string where = "Propagation > Toughness is " + formatReal(atRest) + " J/m2: ";
  const std::string advice = "; it is an energy in J/m2: from K_Ic in Pa m^0.5 it is K_Ic^2 / E', and "
                             "1 MPa m^0.5 is 1e6 Pa m^0.5";
  // Van der Waals solids take 0.05 J/m2 for two new surfaces, the toughest steels some 5e5 J/m2; of stiff
  // solids polyethylene has the largest Gc / E, 2e-5 m.
  const bool stiffSolid = soft.linear && soft.moduli.young > 1e9;
  if (most < 0.05 || atRest > 2e6 || (stiffSolid && atRest > 5e-5 * soft.moduli.young))
    state.warnings.push_back(where +
                             (most < 0.05 ? "less than the surfaces of any solid take"
                                          : "more than any solid of that stiffness takes") +
                             advice);
  // A linear law is off by as much as the strain over the crack at which it runs.
  const double strain = griffith(soft, atRest) / soft.moduli.effectiveModulus;
  if (soft.linear && strain > mostStrain)
    state.warnings.push_back(where + "a crack of " + readableLength(longest) + " needs a strain of " +
                             formatShort(100.0 * strain) + " % in " + soft.material +
                             ", where no linear law holds" + advice);
  double highest = 0.0;
  for (const LoadEstimate& load : loads)
    highest = std::max(highest, load.highest);
  const bool others = run.heat() || !run.pressedCracks.empty(); // load the crack, too
  const LoadEstimate* load = largestStrain(loads);
  const double needed = griffith(soft, atRest);
  if (!others && highest > 0.0 && highest * margin < needed)
    state.warnings.push_back(where + "a crack of " + readableLength(longest) + " runs at a stress of about " +
                             formatShort(needed) + " Pa (sqrt(E' Gc / (pi a))), " +
                             formatShort(needed / highest) + " times the most that the loads make" + advice);
  if (load != nullptr && load->stress > margin * griffith(stiff, most))
  {
    const double length = stiff.moduli.effectiveModulus * most / (pi * load->stress * load->stress);
    state.warnings.push_back(where + "under the " + formatShort(load->stress) + " Pa of " + load->where +
                             " a flaw of " + readableLength(length) + " would run (E' Gc / (pi sigma^2), " +
                             formatShort(length / state.mesh.smallestSpacing()) + " cells)" + advice);
  }
}

} // namespace Rhegma::propagation
