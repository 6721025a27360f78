#include "propagation/Report.hpp"

#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "transfer/NearestMaterial.hpp"

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

/// \param closest largest G over its initiation toughness, below one
std::string reachedAtMost(double closest)
{
  constexpr double least = 0.001;
  if (!(closest > 0.0))
    return "G was never above 0: no load has come to the front";
  if (closest < least)
    return "G stayed below " + formatReal(least) + " of the initiation toughness";
  return "G reached at most " + formatReal(least * std::floor(closest / least)) +
         " of the initiation toughness";
}

/// How close a front that has not initiated came to initiation, in its entry and in a warning.
template <int D>
void reportRest(const State<D>& state, const CrackFront<D>& front, double closest, double startTime,
                nlohmann::json& summary)
{
  nlohmann::json& entry = summary["cracks"][front.crack]["fronts"][front.number];
  entry["closest_to_initiation"] = closest;
  if (state.clock.step == 0) // a scene that is only checked
    return;
  if (state.clock.time < startTime)
  {
    summary["warnings"].push_back(
        frontName(state.cracks, front) + ": no crack may advance before " + readableTime(startTime) +
        " (Propagation > Start Time), and the run ended at " + readableTime(state.clock.time));
    return;
  }
  const bool closed = entry.value("closed", false); // by Energy Release
  summary["warnings"].push_back(
      frontName(state.cracks, front) + ": not initiated" +
      (closed ? ", and closed at the end (K_I < 0); counting also the G that closes it, " : "; ") +
      reachedAtMost(closest));
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

/// How far a front ran, where to and how fast. \param position where it is now [m]
std::string extensionAsText(const std::vector<CrackRun>& runs, const FrontExtension&,
                            const Vector<2>& position)
{
  double length = 0.0, duration = 0.0;
  for (const CrackRun& run : runs)
  {
    length += run.length;
    duration += run.lastAdvance - run.initiation;
  }
  std::string text = "extension " + readableLength(length) + " to " + formatShort(position[0]) + ", " +
                     formatShort(position[1]) + " m";
  if (duration > 0.0)
    text += ", mean speed " + formatShort(length / duration) + " m/s";
  return text;
}

std::string extensionAsText(const std::vector<CrackRun>&, const FrontExtension& extension, const Vector<3>&)
{
  return "extension " + readableLength(extension.largest) + " at most, " + readableLength(extension.mean) +
         " on average, new area " + formatShort(extension.area) + " m2";
}

/// How far a front has grown in equilibrium, and where to.
template <int D>
std::string growthAsText(const CrackFront<D>& front)
{
  std::string text = "grew by " + readableLength(front.extension.largest);
  text += D == 3 ? " at most, " + readableLength(front.extension.mean) + " on average, new area " +
                       formatShort(front.extension.area) + " m2"
                 : " to " + formatShort(front.position[0]) + ", " + formatShort(front.position[1]) + " m";
  return text + (front.arrival.happened() ? ", " + front.arrival.what : "");
}

/// When, how often, how far, where to and how fast a front ran.
template <int D>
std::string runsAsText(const std::vector<CrackRun>& runs, const CrackFront<D>& front)
{
  std::string text = "initiated at t = " + readableTime(runs.front().initiation);
  if (runs.size() > 1)
    text += ", arrested and reinitiated " + std::to_string(runs.size() - 1) + " times";
  return text + ", " + extensionAsText(runs, front.extension, front.position);
}

enum class Fate
{
  NotInitiated,
  Running,
  Growing,  ///< in equilibrium, at its toughness
  Arrested, ///< G is below the toughness everywhere
  AtRest,   ///< it is not
  Stopped,  ///< a numerical reason stopped nodes of it
  Ended
};

/// What became of a front.
template <int D>
struct FrontEnd
{
  Fate fate = Fate::Ended;
  bool inPart = false; ///< other nodes have neither stopped nor landed
  /// Of the node that can advance and is closest to its toughness [J/m2]; 0: there is none
  double release = 0.0, toughness = 0.0;
  /// Running, but with G below the toughness and without an advance for three times the mean time between
  /// two: its speed is then only a bound (2D)
  bool pauses = false;

  FrontEnd(const State<D>& state, const Options& options, const CrackFront<D>& front,
           const FrontState<D>& own)
  {
    bool any = false;
    // Intensities are known where a node is about to advance.
    const bool opening = !front.ended && front.advances();
    const Elasticity e =
        elasticity(state.materials.properties[opening ? materialAt(state, front.position) : std::size_t(0)]);
    for (const FrontNode<D>& node : front.nodes)
      if (!node.stopped && !front.ended)
      {
        const double opens = opening ? openingRelease(node.driving, e) : node.driving.release;
        const double needed = ruleAt(node.temperature, options).initiation;
        if (!any || opens * toughness > release * needed)
        {
          release = opens;
          toughness = needed;
        }
        any = true;
      }
    inPart = any;
    if (front.numStopped() > 0)
      fate = Fate::Stopped;
    else if (!any)
      fate = Fate::Ended;
    else if (own.running(front) && !options.equilibrium)
      fate = Fate::Running;
    else if (own.increments == 0)
      fate = Fate::NotInitiated;
    else if (state.method.analysis == Analysis::LoadFactor ||
             (options.equilibrium && own.lastTime >= state.clock.time - 0.5 * state.clock.dt))
      fate = Fate::Growing; // in the last load step
    else
      fate = release < toughness ? Fate::Arrested : Fate::AtRest;
    const double between = own.increments > 1 ? (own.lastTime - own.firstTime) / (own.increments - 1) : 0.0;
    pauses = D == 2 && fate == Fate::Running && release < toughness && own.increments > 1 &&
             state.clock.time - own.lastTime > 3.0 * between;
  }
};

/// How many front nodes stopped, why, and at what G for which toughness.
template <int D>
std::string stopAsText(const CrackFront<D>& front)
{
  std::string text;
  if (D == 3)
    text = std::to_string(front.numStopped()) + " of " + std::to_string(front.nodes.size()) + " front nodes ";
  return text + "stopped " + front.stop.what + (D == 3 ? ", the first at t = " : " at t = ") +
         readableTime(front.stop.time) +
         " (a numerical stop, not arrest): G = " + formatShort(front.stop.release) +
         " J/m2 for Gc = " + formatShort(front.stop.toughness) + " J/m2";
}

/// What became of a front in the end.
template <int D>
std::string fateAsText(const CrackFront<D>& front, const FrontState<D>& own, const FrontEnd<D>& end)
{
  const std::string runs = "still running at the end" +
                           (front.speed() > 0.0 ? " at " + formatShort(front.speed()) + " m/s"
                                                : std::string(", after too few increments for a speed"));
  switch (end.fate)
  {
  case Fate::Stopped:
    return stopAsText(front) + (own.running(front) ? "; the others are " + runs : "");
  case Fate::Ended:
    return front.arrival.happened() ? front.arrival.what + " at t = " + readableTime(front.arrival.time)
                                    : "whole front at a surface since t = " + readableTime(own.lastTime);
  case Fate::Running:
    return end.pauses
               ? "no advance since t = " + readableTime(own.lastTime) + ", G = " + formatShort(end.release) +
                     " J/m2 below Gc = " + formatShort(end.toughness) +
                     " J/m2, but too short ago to count as arrested: run longer (Time > Final Time)"
               : runs;
  case Fate::Arrested:
  {
    const auto [release, toughness] = own.arrest();
    const bool known = toughness > 0.0; // else the nodes that ran have landed
    return "arrested at t = " + readableTime(own.lastTime) +
           ", G = " + formatShort(known ? release : end.release) +
           " J/m2 below Gc = " + formatShort(known ? toughness : end.toughness) + " J/m2";
  }
  default:
    return "at rest at the end, G = " + formatShort(end.release) +
           " J/m2 for Gc = " + formatShort(end.toughness) + " J/m2";
  }
}

/// The status of a front: one word, and the reason of a stop.
template <int D>
std::string statusOf(const CrackFront<D>& front, const FrontEnd<D>& end)
{
  switch (end.fate)
  {
  case Fate::Stopped:
    return (end.inPart ? "stopped in part, " + std::to_string(front.numStopped()) + " of " +
                             std::to_string(front.nodes.size()) + " front nodes: "
                       : "stopped: ") +
           front.stop.what;
  case Fate::Ended:
    return "ended";
  case Fate::Running:
    return end.pauses ? "pausing" : "running";
  case Fate::Growing:
    return "growing";
  case Fate::NotInitiated:
    return "not initiated";
  case Fate::Arrested:
    return "arrested";
  default:
    return "at rest";
  }
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
void reportPath(const CrackFront<2>& front, const FrontState<2>& own, bool equilibrium, nlohmann::json& entry)
{
  const bool moved = own.increments > 0;
  const PathStart<2>& start = own.start;
  entry["first_turn"] = moved ? angleBetween(start.direction, start.first) : notYet;
  entry["turn"] = moved ? angleBetween(start.direction, front.position - start.position) : notYet;
  if (equilibrium) // the time of its increments has no meaning
    return;
  const FrontHistory& history = own.nodes.at(front.nodes[0].name).history;
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

namespace
{

/// Warns where G of the history is not that by which growth was found, which may have another contour.
/// \param release of the latter [J/m2] \param entry of the front
void compareContours(const std::string& name, double release, const nlohmann::json& entry,
                     nlohmann::json& summary)
{
  constexpr double most = 0.1;
  const auto found = entry.find("G_J");
  if (found == entry.end() || !found->is_number() || !(release > 0.0))
    return;
  const double ratio = found->get<double>() / release;
  if (std::fabs(ratio - 1.0) > most)
    summary["warnings"].push_back(name + ": grows at G = " + formatShort(release) +
                                  " J/m2 of its Release Contour, but G_J of Energy Release is " +
                                  formatShort(100.0 * ratio) +
                                  " % of that: one of these contours is next to a surface, a load or another "
                                  "crack, or has few cells; use smaller cells (Domain > Cell Size)");
}

/// The entry of a front. \return its runs
template <int D>
std::vector<CrackRun> reportFront(const CrackFront<D>& front, const FrontState<D>& own,
                                  const FrontEnd<D>& end, bool equilibrium, nlohmann::json& entry)
{
  const bool moved = own.increments > 0;
  entry["increments"] = own.increments;
  entry["status"] = statusOf(front, end);
  entry["running"] = own.running(front) && !equilibrium;
  entry["ended"] = front.ended;
  entry["stopped"] = front.numStopped() > 0;
  entry["initiated"] = moved ? own.firstTime : notYet;
  entry["last_advance"] = moved ? own.lastTime : notYet;
  if (!equilibrium)
  {
    const double speed = own.settledSpeed();
    entry["settled_speed"] = speed > 0.0 ? speed : notYet; // too few increments
    entry["speed_limit"] = own.speedLimit;
  }
  entry["energy_of_new_faces"] = front.budget.required;
  std::vector<CrackRun> runs;
  if constexpr (D == 2)
  {
    reportPath(front, own, equilibrium, entry);
    runs = own.nodes.at(front.nodes[0].name).history.runs();
  }
  else if (moved) // nodes initiate and arrest one by one, and there is no single length
    runs = {{own.firstTime, own.lastTime, notYet}};
  entry["runs"] = entryOfRuns(runs);
  return runs;
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
    const std::vector<CrackRun> runs = reportFront(front, own, end, options.equilibrium, entry);
    if (end.fate == Fate::Growing)
      compareContours(name, end.release, entry, summary);
    const bool moved = own.increments > 0, stopped = end.fate == Fate::Stopped;
    if (moved && options.equilibrium && !stopped)
      summary["answers"].push_back(name + ": " + growthAsText(front));
    else if (moved || stopped)
      summary["answers"].push_back(name + ": " + (moved ? runsAsText(runs, front) + ", " : "") +
                                   fateAsText(front, own, end));
    else if (end.fate == Fate::NotInitiated && state.method.analysis != Analysis::LoadFactor)
      reportRest(state, front, own.closest(), options.rule.startTime, summary);
    if (stopped && options.endsAtStops && !summary.contains("ended_by"))
      summary["ended_by"] = name + (D == 2 ? " " : ": ") + fateAsText(front, own, end) + adviceAtStop;
  }
  reportEnergy(state, required, summary);
}

void reportToughness(const Options& options, nlohmann::json& summary)
{
  summary["propagation"]["initiation_toughness"] = ruleAt(options.temperature, options).initiation;
}

template void reportFronts(const State<2>&, const std::vector<FrontState<2>>&, const Options&,
                           nlohmann::json&);
template void reportFronts(const State<3>&, const std::vector<FrontState<3>>&, const Options&,
                           nlohmann::json&);

} // namespace Rhegma::propagation
