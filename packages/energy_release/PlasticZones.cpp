#include "energy_release/PlasticZones.hpp"

#include "base/IntensityText.hpp"
#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "material/Laws.hpp"
#include "material/MaterialTable.hpp"
#include "plausibility/CrackExtent.hpp"
#include "transfer/NearestMaterial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace Rhegma::energy_release
{

namespace
{

double numberIn(const nlohmann::json& entry, const char* name, double otherwise)
{
  return entry.contains(name) && entry[name].is_number() && std::isfinite(entry[name].get<double>())
             ? entry[name].get<double>()
             : otherwise;
}

/// The largest G of the run [J/m2]; 0 where none is known, or where the faces are pressed together.
double largestRelease(const nlohmann::json& entry)
{
  if (entry.value("closed", false))
    return 0.0;
  double largest = 0.0;
  for (const char* const name : {"G_J", "G_J_max", "largest_G_J"})
    largest = std::max(largest, numberIn(entry, name, 0.0));
  return largest;
}

/// What a zone is compared with.
struct Bounds
{
  double crack, ligament, outer;
  bool flows; ///< the law of the material does
};

/// Of what a zone is no small part, as text; empty where it is small. \param zone twice Irwin's radius [m]
std::string exceededBy(double zone, const Bounds& bounds)
{
  constexpr double part = 2.0 * smallZone;
  if (zone > part * std::min(bounds.crack, bounds.ligament))
    return "more than a fifth of the " +
           (bounds.crack < bounds.ligament ? "crack's " + readableLength(bounds.crack)
                                           : readableLength(bounds.ligament) + " of material ahead of it") +
           "; K and G assume small-scale yielding: use a smaller load, or a larger body and crack";
  if (bounds.flows && zone > bounds.outer)
    return "more than the outer radius of its domain integral, " + readableLength(bounds.outer) +
           ", so that J depends on the radius: use a larger Energy Release > Outer Radius";
  return {};
}

/// For which loads a zone is, as text.
std::string loadsAsText(const ToughnessReached::Factors& start)
{
  return start.ofNow == 1.0 && start.ofScene == 1.0
             ? std::string()
             : ", at " + formatShort(start.ofScene) + " times the loads, at which the cracks start,";
}

} // namespace

template <int D>
void reportPlasticZones(const State<D>& state, const std::vector<FrontSample<D>>& samples,
                        const ToughnessReached::Factors& start, const std::string& estimate,
                        nlohmann::json& summary)
{
  if (state.clock.step == 0 && !estimate.empty())
    summary["warnings_of_a_check"].push_back(estimate);
  const auto& all = state.materials.properties;
  if (!state.method.mechanics || state.clock.step == 0 ||
      std::none_of(all.begin(), all.end(), [](const Properties& m) { return firstYield(m) > 0.0; }))
    return;
  for (const FrontSample<D>& sample : samples)
  {
    const CrackFront<D>& front = sample.front;
    nlohmann::json& entry = summary["cracks"][front.crack]["fronts"][front.number];
    // Of the nodes that are compared with the toughness, where there is one.
    const double closest = numberIn(entry, "closest_to_initiation", -1.0);
    const double release = closest > 0.0 && start.toughness > 0.0
                               ? std::min(largestRelease(entry), closest * start.toughness)
                               : largestRelease(entry);
    const int m = materialAt(state, front.position);
    const double yield = firstYield(all[m]);
    if (!(yield > 0.0))
      continue;
    entry["plastic_zone"] = nullptr;
    if (front.ended || !(release > 0.0))
      continue;
    const double K = start.ofNow * std::sqrt(elasticity(all[m]).effectiveModulus * release);
    const double zone = 2.0 * irwinRadius(K, yield, state.method.plane);
    entry["plastic_zone"] = zone;
    const double far = std::numeric_limits<double>::infinity();
    const std::string exceeded =
        exceededBy(zone, {extentOf(state, front.crack), numberIn(entry, "ligament", far),
                          numberIn(entry, "outer_radius", far), all[m].law != lawIndex<LinearElastic>});
    if (!exceeded.empty())
      summary["warnings"].push_back(
          frontName(state.cracks, front) + ": with K = " + intensityAsText(K) + loadsAsText(start) +
          " some " + readableLength(zone) + " ahead of it yield (twice Irwin's radius in plane " +
          (state.method.plane == Plane::Stress ? "stress" : "strain") + ") at Materials > " +
          state.materials.names[m] + " > Yield Stress = " + formatShort(yield) + " Pa, " + exceeded);
  }
}

template void reportPlasticZones(const State<2>&, const std::vector<FrontSample<2>>&,
                                 const ToughnessReached::Factors&, const std::string&, nlohmann::json&);
template void reportPlasticZones(const State<3>&, const std::vector<FrontSample<3>>&,
                                 const ToughnessReached::Factors&, const std::string&, nlohmann::json&);

} // namespace Rhegma::energy_release
