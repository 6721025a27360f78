#include "propagation/Report.hpp"

#include "base/Counted.hpp"
#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "propagation/FirstAdvance.hpp"
#include "propagation/FrontEnd.hpp"
#include "propagation/FrontWarnings.hpp"
#include "propagation/HoopStress.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace Rhegma::propagation
{

namespace
{

constexpr double notYet = std::numeric_limits<double>::quiet_NaN(); ///< null in the summary

/// Fraction by which faces may over-dissipate before a warning says so: usual runs stay within 5 %.
constexpr double mostTooMuch = 0.1;

/// What helps where a front stops for a numerical reason.
constexpr const char* adviceAtStop =
    "; use smaller cells (Domain > Cell Size), or let the rest of the run go on (Propagation > On Stop = "
    "Continue)";

/// All runs of a front, for its entry.
nlohmann::json entryOfRuns(const std::vector<CrackRun>& runs)
{
  nlohmann::json entry = nlohmann::json::array();
  for (const CrackRun& run : runs)
    entry.push_back(
        {{"initiated", run.initiation}, {"last_advance", run.lastAdvance}, {"length", run.length}});
  return entry;
}

/// How far a front ran, where to and how fast.
std::string extensionAsText(const std::vector<CrackRun>& runs, const CrackFront<2>& front,
                            const FrontState<2>& own)
{
  double length = 0.0;
  for (const CrackRun& run : runs)
    length += run.length;
  const double speed = own.nodes.at(front.nodes[0].name).history.meanSpeed();
  return "extension " + readableLength(length) + " to " + formatShort(front.position[0]) + ", " +
         formatShort(front.position[1]) + " m" +
         (speed > 0.0 ? ", mean speed " + formatShort(speed) + " m/s" : std::string());
}

std::string extensionAsText(const std::vector<CrackRun>&, const CrackFront<3>& front, const FrontState<3>&)
{
  const FrontExtension& extension = front.extension;
  return "extension " + readableLength(extension.largest) + " at most, " + readableLength(extension.mean) +
         " on average, new area " + formatShort(extension.area) + " m2";
}

/// How far a front has grown in equilibrium, and where to.
template <int D>
std::string growthAsText(const CrackFront<D>& front, long increments, const std::string& hold)
{
  std::string text = "grew by " + readableLength(front.extension.largest);
  text += D == 3 ? " at most, " + readableLength(front.extension.mean) + " on average, new area " +
                       formatShort(front.extension.area) + " m2"
                 : " to " + formatShort(front.position[0]) + ", " + formatShort(front.position[1]) + " m";
  return text + ", " + counted(increments, D == 3 ? "node increment" : "increment") + hold +
         (front.arrival.happened() ? ", " + front.arrival.what : "");
}

/// "; as it started, K_II is 23 % of K_I" of a front in 3D. \param entry of the front
std::string startedWithShear(const nlohmann::json& entry)
{
  const std::string shear = shearAtStart(entry);
  return shear.empty() ? shear : "; " + shear;
}

/// Angle from a to b, counter-clockwise [degrees].
double angleBetween(const Vector<2>& a, const Vector<2>& b)
{
  return std::atan2(a[0] * b[1] - a[1] * b[0], dot(a, b)) * 45.0 / std::atan(1.0);
}

/// When, how often, how far, where to and how fast a front ran.
template <int D>
std::string runsAsText(const std::vector<CrackRun>& runs, const CrackFront<D>& front,
                       const FrontState<D>& own, const Options& options, const nlohmann::json& entry)
{
  std::string text = "initiated at t = " + readableTime(runs.front().initiation) + holdAsText(options, entry);
  if (runs.size() > 1)
    text += ", arrested and reinitiated " + counted(static_cast<long>(runs.size()) - 1, "time");
  const std::string shear = D == 3 ? shearAtStart(entry) : effectOfShear(entry),
                    closure = D == 3 ? std::string() : closureAsText(entry);
  return text + ", " + extensionAsText(runs, front, own) +
         (shear.empty() ? "" : "; " + shear + (D == 3 ? "" : " at that time")) +
         (closure.empty() ? "" : "; " + closure);
}

/// Mean time and position of the points of a path between two times; not numbers where there are none.
PathPoint<2> settledMean(const std::vector<PathPoint<2>>& path, const std::pair<double, double>& times)
{
  PathPoint<2> sum;
  int count = 0;
  for (const PathPoint<2>& point : path)
    if (point.time >= times.first && point.time <= times.second)
    {
      sum.time += point.time;
      sum.position = sum.position + point.position;
      ++count;
    }
  if (count == 0 || !(times.second > times.first))
    return {notYet, {{notYet, notYet}}};
  return {sum.time / count, {{sum.position[0] / count, sum.position[1] / count}}};
}

/// What is left ahead of a front, where that is known (Cracks).
std::string ligamentAsText(const nlohmann::json& entry)
{
  const auto found = entry.find("ligament");
  const std::string end = entry.contains("ligament_ends_at") && entry["ligament_ends_at"].is_string()
                              ? entry["ligament_ends_at"].get<std::string>()
                              : std::string();
  return found != entry.end() && found->is_number()
             ? "; " + readableLength(found->get<double>()) + " of material ahead of it" +
                   (end.rfind("crack ", 0) == 0 ? ", up to " + end : std::string())
             : std::string();
}

/// Warns of a front so slow that cells hold it: where it is arrested depends on them.
template <int D>
void warnOfStickSlip(const State<D>& state, const CrackFront<D>& front, const FrontState<D>& own,
                     const Options& options, nlohmann::json& summary)
{
  constexpr double slowest = 0.1; // of Rayleigh waves (docs/explanation/crack-growth.md)
  constexpr double fewest = 4.0;  // increments of each node
  const double time = own.lastTime - own.firstTime;
  if (options.equilibrium || !(time > 0.0) || !(options.waveSpeed > 0.0) ||
      static_cast<double>(own.increments) <
          fewest * static_cast<double>(std::max<std::size_t>(front.nodes.size(), 1)))
    return;
  const double speed = front.extension.largest / time;
  if (speed < slowest * options.waveSpeed)
    summary["warnings"].push_back(
        frontName(state.cracks, front) + ": it advanced at " + formatShort(speed) + " m/s on average, " +
        formatShort(speed / options.waveSpeed) +
        " of the speed of Rayleigh waves; cracks slower than a tenth of it stick and slip from cell to cell, "
        "so "
        "that their speed, and where they are arrested, depends on the cells: compare with half of their "
        "size "
        "(--twice), or let it grow in equilibrium (Time > Analysis = Quasi-Static)");
}

/// Warns of a front that runs at its speed limit: the limit determines its speed, not the toughness.
template <int D>
void warnOfSpeedLimit(const State<D>& state, const CrackFront<D>& front, const FrontState<D>& own,
                      const Options& options, nlohmann::json& summary)
{
  constexpr double asFast = 0.98; // of the limit; what runs more slowly is determined by the toughness
  const double speed = own.settledSpeed();
  if (options.equilibrium || !(own.speedLimit > 0.0) || !(speed >= asFast * own.speedLimit))
    return;
  summary["warnings"].push_back(
      frontName(state.cracks, front) + ": it ran at " + formatShort(speed) + " m/s, its speed limit (" +
      (options.speedLimit > 0.0 ? "Propagation > Speed Limit" : "the speed of Rayleigh waves") +
      "), where G exceeds the toughness at any speed: the limit determines how fast and how far it runs. "
      "Cracks in "
      "brittle solids branch above about half the speed of Rayleigh waves; write a Toughness that rises with "
      "the "
      "speed v");
}

/// The path of a front with one node.
void reportPath(const CrackFront<2>& front, const FrontState<2>& own, const Options& options,
                nlohmann::json& entry)
{
  const bool moved = own.increments > 0;
  const PathStart<2>& start = own.start;
  const double turn = moved ? angleBetween(start.direction, start.first) : notYet;
  entry["first_turn"] = turn;
  entry["turn"] = moved ? angleBetween(start.direction, front.position - start.position) : notYet;
  if (options.equilibrium) // the time of its increments has no meaning
    return;
  const FrontHistory& history = own.nodes.at(front.nodes[0].name).history;
  const double speed = history.meanSpeed();
  entry["mean_speed"] = speed > 0.0 ? speed : notYet;
  entry["settled_release"] = history.settledRelease();
  const PathPoint<2> mean = settledMean(own.path, history.settled());
  entry["settled_time"] = mean.time;
  entry["settled_position"] = {mean.position[0], mean.position[1]};
}

/// The energy of new faces: required, released and pending. \param required by all fronts [J]
template <int D>
void reportEnergy(const State<D>& state, double required, nlohmann::json& summary)
{
  const EnergyBalance& energy = state.energy;
  const double mechanical = energy.start + std::fabs(energy.externalWork) + std::fabs(energy.combustion);
  // Of the heat of an equilibrium some millionths do work.
  const double given = !state.method.equilibrium() ? mechanical + std::fabs(energy.heat)
                       : energy.heat != 0.0        ? std::max(mechanical, energy.strain + energy.fracture)
                                                   : mechanical;
  const double inFlight = summary.value("energy_in_flight", 0.0);
  summary["propagation"] = {
      {"energy_of_new_faces", required},
      {"in_flight", inFlight},
      {"dissipated", energy.fracture},
      {"accounted_for", given > 0.0 ? 1.0 - energy.residual() / given : notYet},
      {"dissipated_fraction", required > inFlight ? energy.fracture / (required - inFlight) : notYet},
      {"residual_fraction", required > 0.0 ? energy.residual() / required : notYet}};
  if (required > inFlight && energy.fracture > (1.0 + mostTooMuch) * required)
    summary["warnings"].push_back(
        "Propagation: new faces dissipated " + readableEnergy(energy.fracture) +
        ", more than their toughness times their area, " + readableEnergy(required) +
        ": faces opened within one step, or the front passed nodes because the body moved through its cells; "
        "ramp the load, take smaller cells (Domain > Cell Size), or support the body");
}

/// The entry of a front. \return its runs
template <int D>
std::vector<CrackRun> reportFront(const State<D>& state, const CrackFront<D>& front, const FrontState<D>& own,
                                  const FrontEnd<D>& end, const Options& options, nlohmann::json& entry)
{
  const bool moved = own.increments > 0;
  entry["increments"] = own.increments;
  entry["status"] = statusOf(front, end);
  entry["closest_to_initiation"] = notYet; // of a front that was
  reportHoopStart(state, options, own, entry);
  reportFirstAdvance(state, options, own, entry);
  entry["running"] = own.running(front) && !options.equilibrium;
  entry["ended"] = front.ended;
  entry["stopped"] = front.numStopped() > 0;
  entry["initiated"] = moved ? own.firstTime : notYet;
  entry["last_advance"] = moved ? own.lastTime : notYet;
  if (!options.equilibrium)
  {
    const double speed = own.settledSpeed();
    entry["settled_speed"] = speed > 0.0 ? speed : notYet; // too few increments
    entry["speed_limit"] = own.speedLimit;
  }
  entry["energy_of_new_faces"] = front.budget.required;
  std::vector<CrackRun> runs;
  if constexpr (D == 2)
  {
    reportPath(front, own, options, entry);
    runs = own.nodes.at(front.nodes[0].name).history.runs();
  }
  else if (moved) // nodes initiate and arrest one by one, and there is no single length
    runs = {{own.firstTime, own.lastTime, notYet}};
  entry["runs"] = entryOfRuns(runs);
  return runs;
}

/// Of growth under given loads in equilibrium: fronts that grew in the last load step, as the loads still
/// rise, or whose G is above the toughness.
template <int D>
void reportUnstopped(const State<D>& state, const std::vector<FrontState<D>>& fronts, const Options& options,
                     nlohmann::json& summary)
{
  if (!options.equilibrium || state.method.analysis == Analysis::LoadFactor)
    return;
  constexpr double noticeable = 1.01; // G over the toughness: G is no more accurate
  std::vector<std::string> names;
  double most = 0.0;
  for (std::size_t f = 0; f < fronts.size(); ++f)
  {
    const CrackFront<D>& front = state.cracks.fronts[f];
    const FrontEnd<D> end(state, options, front, fronts[f]);
    const double ratio = end.toughness > 0.0 ? end.release / end.toughness : 0.0;
    if (fronts[f].increments == 0 || !end.inPart || (end.fate != Fate::Growing && !(ratio > noticeable)))
      continue;
    names.push_back(frontName(state.cracks, front));
    most = std::max(most, ratio);
  }
  summary["propagation"]["not_stopped"] = names;
  if (names.empty())
    return;
  const bool one = names.size() == 1;
  summary["answers"].push_back(
      (one ? names.front() + ": the crack has not stopped: its"
           : counted(static_cast<long>(names.size()), "front") + " (" + names.front() +
                 " and others): the cracks have not stopped: their") +
      " growth is that of the loads up to t = " + readableTime(state.clock.time) +
      (most > noticeable ? ", where G is still " + formatShort(most) + " times the toughness" : ""));
}

} // namespace

template <int D>
void reportFronts(const State<D>& state, const std::vector<FrontState<D>>& fronts, const Options& options,
                  nlohmann::json& summary)
{
  double required = 0.0;
  for (std::size_t f = 0; f < state.cracks.fronts.size(); ++f)
  {
    const CrackFront<D>& front = state.cracks.fronts[f];
    const FrontState<D>& own = fronts[f];
    const FrontEnd<D> end(state, options, front, own);
    const std::string name = frontName(state.cracks, front);
    required += front.budget.required;
    nlohmann::json& entry = summary["cracks"][front.crack]["fronts"][front.number];
    const std::vector<CrackRun> runs = reportFront(state, front, own, end, options, entry);
    compareContours(name, own.contours, summary);
    warnOfStickSlip(state, front, own, options, summary);
    warnOfSpeedLimit(state, front, own, options, summary);
    const bool moved = own.increments > 0, stopped = end.fate == Fate::Stopped;
    if (moved && options.equilibrium && !stopped)
      summary["answers"].push_back(name + ": " +
                                   growthAsText(front, own.increments, holdAsText(options, entry)) +
                                   startedWithShear(entry) + ligamentAsText(entry));
    else if (moved || stopped)
      summary["answers"].push_back(name + ": " +
                                   (moved ? runsAsText(runs, front, own, options, entry) + ", " : "") +
                                   fateAsText(front, own, end) + ligamentAsText(entry));
    else if (end.fate == Fate::NotInitiated && state.method.analysis != Analysis::LoadFactor)
      reportRest(state, front, {own.closest(), own.early()}, ruleAt(options.temperature, options), options,
                 summary);
    if (stopped && options.endsAtStops && !summary.contains("ended_by"))
      summary["ended_by"] = name + (D == 2 ? " " : ": ") + fateAsText(front, own, end) + adviceAtStop;
  }
  reportEnergy(state, required, summary);
  reportUnstopped(state, fronts, options, summary);
  const auto& all = state.cracks.fronts;
  if (options.equilibrium && state.clock.time < state.clock.finalTime && !all.empty() &&
      std::all_of(all.begin(), all.end(),
                  [](const CrackFront<D>& front) { return front.ended || front.stopped(); }))
    summary["answers"].push_back("no front is left that can advance: the analysis ends at t = " +
                                 readableTime(state.clock.time) + ", before Time > Final Time");
}

void reportToughness(const Options& options, nlohmann::json& summary)
{
  summary["propagation"]["initiation_toughness"] = ruleAt(options.temperature, options).initiation;
  summary["propagation"]["start_time"] = options.rule.startTime;
  const AdvanceRule rule = ruleAt(options.temperature, options);
  if (options.criticalIntensity > 0.0 && rule.initiation == rule.toughness(0.0, rule.temperature))
    summary["propagation"]["K_Ic"] = options.criticalIntensity;
}

template void reportFronts(const State<2>&, const std::vector<FrontState<2>>&, const Options&,
                           nlohmann::json&);
template void reportFronts(const State<3>&, const std::vector<FrontState<3>>&, const Options&,
                           nlohmann::json&);

} // namespace Rhegma::propagation
