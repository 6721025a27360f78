#include "propagation/Report.hpp"

#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"

#include <cmath>
#include <limits>
#include <string>

namespace Rhegma::propagation
{

namespace
{

template <int D>
std::string nameOf(const State<D>& state, const CrackFront<D>& front)
{
  return state.cracks.cracks[front.crack].name + "." + std::to_string(front.number);
}

/// Runs of a front of which the answers tell, beside its last.
constexpr std::size_t mostTold = 3;

/// Share by which faces may take more than is booked before a warning says so: sound runs stay within 5 %.
constexpr double mostTooMuch = 0.1;

} // namespace

template <int D>
void reportRest(const State<D>& state, const CrackFront<D>& front, double closest, nlohmann::json& summary)
{
  summary["cracks"][front.crack]["fronts"][front.number]["closest_to_setting_out"] = closest;
  if (state.clock.step == 0) // a scene that is only checked
    return;
  const double rounded = 0.001 * std::floor(1000.0 * closest); // below one
  summary["warnings"].push_back("the front " + nameOf(state, front) + " did not set out: G at most " +
                                formatReal(rounded) + " of what starts it");
}

template <int D>
void reportRuns(const State<D>& state, const CrackFront<D>& front, const std::vector<CrackRun>& runs,
                bool running, double speed, nlohmann::json& summary)
{
  nlohmann::json& entry = summary["cracks"][front.crack]["fronts"][front.number]["runs"];
  entry = nlohmann::json::array();
  for (const CrackRun& run : runs)
    entry.push_back({{"set_out", run.setOut}, {"last_advance", run.lastAdvance}, {"length", run.length}});
  if (runs.empty())
    return;
  for (std::size_t r = 0; r < runs.size(); ++r)
  {
    const bool isLast = r + 1 == runs.size();
    if (r >= mostTold && !isLast)
      continue; // `runs` has them all
    const CrackRun& run = runs[r];
    std::string answer =
        "the front " + nameOf(state, front) + " set out at " + shortly(run.setOut) + " s and ";
    if (isLast && running)
      answer += "was running at the end, at " + shortly(speed) + " m/s";
    else
      answer +=
          (isLast && front.ended ? "met its end at " : "came to rest at ") + shortly(run.lastAdvance) + " s";
    if (std::isfinite(run.length))
      answer += ", " + shortly(run.length) + " m on";
    summary["answers"].push_back(answer);
  }
}

template <int D>
void reportEnergy(const State<D>& state, double taken, nlohmann::json& summary)
{
  constexpr double notYet = std::numeric_limits<double>::quiet_NaN(); // null in the summary
  // What the body has been given, and how much of it the ledger knows of now.
  const EnergyBalance& energy = state.energy;
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
  if (taken > inFlight && energy.fracture > (1.0 + mostTooMuch) * taken)
    summary["warnings"].push_back(
        "Propagation: new faces took " + shortly(energy.fracture) + " J, where their toughness asks for " +
        shortly(taken) +
        " J: faces were torn open within a step or nodes passed the front as the body moved through its "
        "cells; a gentler load, smaller cells or a body that stays where it is gives the toughness its due");
}

void reportToughness(const Options& options, nlohmann::json& summary)
{
  summary["propagation"]["initiation_toughness"] = ruleAt(options.temperature, options).initiation;
}

template void reportRest(const State<2>&, const CrackFront<2>&, double, nlohmann::json&);
template void reportRest(const State<3>&, const CrackFront<3>&, double, nlohmann::json&);
template void reportRuns(const State<2>&, const CrackFront<2>&, const std::vector<CrackRun>&, bool, double,
                         nlohmann::json&);
template void reportRuns(const State<3>&, const CrackFront<3>&, const std::vector<CrackRun>&, bool, double,
                         nlohmann::json&);
template void reportEnergy(const State<2>&, double, nlohmann::json&);
template void reportEnergy(const State<3>&, double, nlohmann::json&);

} // namespace Rhegma::propagation
