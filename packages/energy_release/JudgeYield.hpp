#pragma once
/// Whether plastic flow leaves K and G their meaning (docs/reference/warnings-of-cracks-and-runs.md).

#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "plausibility/CrackExtent.hpp"
#include "plausibility/LoadEstimate.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace Rhegma::energy_release
{

/// Whether the nominal stress of the loads makes a body yield as a whole, or the zone that yields at a crack
/// is no small part of it, by K = sigma sqrt(pi a): K and G = K^2 / E' are those of a body that is elastic
/// around a small zone. A run judges the zone by the K that it computes (PlasticZones.hpp).
/// \param scene its core \return (a warning, whether it is of the zone); empty if there is none
template <int D>
std::pair<std::string, bool> judgeYield(const Teuchos::ParameterList& scene, const State<D>& state)
{
  constexpr double pi = 3.14159265358979;
  const std::vector<BodyMeasure<D>> bodies = crackedBodies(state);
  const BodyMeasure<D>* soft = nullptr;
  for (const BodyMeasure<D>& body : bodies)
    if (body.yield > 0.0 && (soft == nullptr || body.yield < soft->yield))
      soft = &body;
  if (soft == nullptr)
    return {};
  const std::vector<LoadEstimate> loads = estimateLoads(scene, state, bodies);
  const LoadEstimate* load = largestStrain(loads);
  if (load == nullptr)
    return {};
  const std::string where =
      "Materials > " + soft->material + " > Yield Stress is " + formatReal(soft->yield) + " Pa, and ";
  const std::string advice = "; K and G (Energy Release) assume small-scale yielding: check units (1 MPa is "
                             "1e6 Pa), or use a larger body and crack";
  const double crack = longestCrack(state), across = shortestAcrossFronts(state, *soft),
               part = std::min(crack, across);
  const double zone = plasticZone(load->stress * std::sqrt(pi * crack), *soft, state.method.plane);
  if (load->stress > soft->yield)
    return {where + load->where + " stresses the body with about " + formatShort(load->stress) +
                " Pa, so that it yields as a whole" + advice,
            false};
  if (zone > smallZone * part)
    return {where + "under the " + formatShort(load->stress) + " Pa of " + load->where + " some " +
                readableLength(2.0 * zone) + " ahead of a crack of " + readableLength(crack) +
                " yield (twice Irwin's radius, by K = sigma sqrt(pi a)), more than a fifth of the " +
                (crack < across ? "crack" : "body's " + readableLength(across)) + advice,
            true};
  return {};
}

} // namespace Rhegma::energy_release
