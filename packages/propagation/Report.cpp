#include "propagation/Report.hpp"

#include "scene/Numbers.hpp"

#include <cmath>
#include <limits>
#include <string>

namespace Rhegma::propagation
{

template <int D>
void reportRest(const State<D>& state, const CrackFront<D>& front, double closest, nlohmann::json& summary)
{
  summary["cracks"][front.crack]["fronts"][front.number]["closest_to_setting_out"] = closest;
  if (state.step == 0) // a scene that is only checked
    return;
  const double rounded = 0.001 * std::floor(1000.0 * closest); // below one
  summary["warnings"].push_back("the front " + state.cracks.cracks[front.crack].name + "." +
                                std::to_string(front.number) + " did not set out: G at most " +
                                formatReal(rounded) + " of what starts it");
}

template <int D>
void reportEnergy(const State<D>& state, double taken, nlohmann::json& summary)
{
  constexpr double notYet = std::numeric_limits<double>::quiet_NaN(); // null in the summary
  // What the body has been given, and how much of it the ledger knows of now.
  const EnergyLedger& energy = state.energy;
  const double given =
      energy.start + std::fabs(energy.externalWork) + std::fabs(energy.combustion) + std::fabs(energy.heat);
  const double inFlight = summary.value("energy_in_flight", 0.0);
  summary["propagation"] = {
      {"energy_of_new_faces", taken},
      {"in_flight", inFlight},
      {"dissipated", energy.fracture},
      {"accounted_for", given > 0.0 ? 1.0 - energy.residual() / given : notYet},
      {"dissipated_share", taken > inFlight ? energy.fracture / (taken - inFlight) : notYet},
      {"residual_share", taken > 0.0 ? energy.residual() / taken : notYet}};
}

template void reportRest(const State<2>&, const CrackFront<2>&, double, nlohmann::json&);
template void reportRest(const State<3>&, const CrackFront<3>&, double, nlohmann::json&);
template void reportEnergy(const State<2>&, double, nlohmann::json&);
template void reportEnergy(const State<3>&, double, nlohmann::json&);

} // namespace Rhegma::propagation
