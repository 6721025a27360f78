#include "propagation/Report.hpp"

#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"

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

/// What helps where the cells stop a front.
constexpr const char* adviceAtStop =
    "; use smaller cells (Domain > Cell Size), or let the rest of the run go on without it (Propagation > On "
    "Stop = Continue)";

template <int D>
std::string nameOf(const State<D>& state, const CrackFront<D>& front)
{
  return "crack " + state.cracks.cracks[front.crack].name + ", front " + std::to_string(front.number);
}

/// How close a front that has not initiated came to initiation, in its entry and in a warning.
template <int D>
void reportRest(const State<D>& state, const CrackFront<D>& front, double closest, nlohmann::json& summary)
{
  summary["cracks"][front.crack]["fronts"][front.number]["closest_to_initiation"] = closest;
  if (state.clock.step == 0) // a scene that is only checked
    return;
  const double rounded = 0.001 * std::floor(1000.0 * closest); // below one
  summary["warnings"].push_back(nameOf(state, front) + ": not initiated; G reached at most " +
                                formatReal(rounded) + " of the initiation toughness");
}

/// All runs of a front, for its entry.
nlohmann::json entryOfRuns(const std::vector<CrackRun>& runs)
{
  nlohmann::json entry = nlohmann::json::array();
  for (const CrackRun& run : runs)
    entry.push_back(
        {{"initiated", run.initiation}, {"last_advance", run.lastAdvance}, {"length", run.length}});
  return entry;
}

/// When, how often, how far, where to and how fast a front ran.
/// \param position where it is now [m]
template <int D>
std::string runsAsText(const std::vector<CrackRun>& runs, const Vector<D>& position)
{
  std::string text = "initiated at t = " + readableTime(runs.front().initiation);
  if (runs.size() > 1)
    text += ", arrested and reinitiated " + std::to_string(runs.size() - 1) + " times";
  double length = 0.0, duration = 0.0;
  for (const CrackRun& run : runs)
  {
    length += run.length;
    duration += run.lastAdvance - run.initiation;
  }
  if (!std::isfinite(length)) // of a line in 3D
    return text;
  text += ", extension " + readableLength(length) + " to ";
  for (int d = 0; d < D; ++d)
    text += formatShort(position[d]) + (d + 1 < D ? ", " : " m");
  if (duration > 0.0)
    text += ", mean speed " + formatShort(length / duration) + " m/s";
  return text;
}

/// What became of a front in the end. \param entry of the front, with what cracks say of it
template <int D>
std::string fateOf(const CrackFront<D>& front, const FrontState<D>& own, const nlohmann::json& entry)
{
  const auto at = [](const nlohmann::json& event)
  { return event["what"].get<std::string>() + " at t = " + readableTime(event["time"].get<double>()); };
  if (entry.contains("stop"))
  {
    const nlohmann::json& stop = entry["stop"];
    return at(stop) + " by the cells, not arrested: G = " + formatShort(stop["G"].get<double>()) +
           " J/m2 for Gc = " + formatShort(stop["toughness"].get<double>()) + " J/m2";
  }
  if (front.ended)
    return entry.contains("arrival") ? at(entry["arrival"]) : "ended";
  if (own.running(front))
    return "still running at the end at " + formatShort(front.speed()) + " m/s";
  const auto [release, toughness] = own.arrest();
  if (toughness > 0.0)
    return "arrested at t = " + readableTime(own.lastTime) + ", G = " + formatShort(release) +
           " J/m2 below Gc = " + formatShort(toughness) + " J/m2";
  return "all of it at a surface since t = " + readableTime(own.lastTime);
}

/// The status of a front: one word, and the reason of a stop.
template <int D>
std::string statusOf(const CrackFront<D>& front, const FrontState<D>& own, const nlohmann::json& entry)
{
  if (entry.contains("stop"))
    return "stopped: " + entry["stop"]["what"].get<std::string>().substr(sizeof "stopped " - 1);
  if (front.ended)
    return "ended";
  if (own.running(front))
    return "running";
  return own.increments == 0 ? "not initiated" : own.arrest().second > 0.0 ? "arrested" : "ended";
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

/// Angle from a to b, counter-clockwise [degrees].
double angleBetween(const Vector<2>& a, const Vector<2>& b)
{
  return std::atan2(a[0] * b[1] - a[1] * b[0], dot(a, b)) * 45.0 / std::atan(1.0);
}

/// The path of a front with one node.
void reportPath(const CrackFront<2>& front, const FrontState<2>& own, nlohmann::json& entry)
{
  const FrontHistory& history = own.nodes.at(front.nodes[0].name).history;
  const bool moved = own.increments > 0;
  const PathStart<2>& start = own.start;
  entry["first_turn"] = moved ? angleBetween(start.direction, start.first) : notYet;
  entry["turn"] = moved ? angleBetween(start.direction, front.position - start.position) : notYet;
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
  const double given =
      energy.start + std::fabs(energy.externalWork) + std::fabs(energy.combustion) + std::fabs(energy.heat);
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

} // namespace

template <int D>
void reportFronts(const State<D>& state, const std::vector<FrontState<D>>& fronts, bool halts,
                  nlohmann::json& summary)
{
  double required = 0.0;
  for (std::size_t f = 0; f < state.cracks.fronts.size(); ++f)
  {
    const CrackFront<D>& front = state.cracks.fronts[f];
    const FrontState<D>& own = fronts[f];
    required += front.budget.required;
    const bool moved = own.increments > 0;
    nlohmann::json& entry = summary["cracks"][front.crack]["fronts"][front.number];
    entry["increments"] = own.increments;
    entry["status"] = statusOf(front, own, entry);
    entry["running"] = own.running(front);
    entry["ended"] = front.ended;
    entry["stopped"] = entry.contains("stop");
    entry["initiated"] = moved ? own.firstTime : notYet;
    entry["last_advance"] = moved ? own.lastTime : notYet;
    entry["settled_speed"] = own.settledSpeed();
    entry["speed_limit"] = own.speedLimit;
    entry["energy_of_new_faces"] = front.budget.required;
    std::vector<CrackRun> runs;
    if constexpr (D == 2)
    {
      reportPath(front, own, entry);
      runs = own.nodes.at(front.nodes[0].name).history.runs();
    }
    else if (moved) // nodes initiate and arrest one by one, and there is no single length
      runs = {{own.firstTime, own.lastTime, notYet}};
    entry["runs"] = entryOfRuns(runs);
    if (moved)
      summary["answers"].push_back(nameOf(state, front) + ": " + runsAsText(runs, front.position) + ", " +
                                   fateOf(front, own, entry));
    else if (!front.ended && !front.stopped())
      reportRest(state, front, own.closest(), summary);
    if (halts && entry.contains("stop") && !summary.contains("halt"))
      summary["halt"] = nameOf(state, front) + " " + fateOf(front, own, entry) + adviceAtStop;
  }
  reportEnergy(state, required, summary);
}

void reportToughness(const Options& options, nlohmann::json& summary)
{
  summary["propagation"]["initiation_toughness"] = ruleAt(options.temperature, options).initiation;
}

template void reportFronts(const State<2>&, const std::vector<FrontState<2>>&, bool, nlohmann::json&);
template void reportFronts(const State<3>&, const std::vector<FrontState<3>>&, bool, nlohmann::json&);

} // namespace Rhegma::propagation
