#include "propagation/PathReport.hpp"

#include "archive/Archive.hpp"
#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "propagation/HoopStress.hpp"

#include <algorithm>

namespace Rhegma::propagation
{

namespace
{

/// Changes that count: the factor is found to within 1e-5, and G to its square.
constexpr double noticeable = 1e-4;

bool fallsAfter(const std::vector<PathState>& path, std::size_t k, double PathState::*value)
{
  return path[k + 1].*value < (1.0 - noticeable) * path[k].*value;
}

std::string asText(const PathState& state)
{
  return formatShort(state.factor) + " (new area " + formatShort(state.area) + " m2)";
}

/// An entry keeps its names when there is no such state (yet), so that a Reference to it is no mistake of the
/// scene, also of a run that goes on from a checkpoint.
nlohmann::json entryOf(const std::vector<PathState>& path, int state)
{
  if (state < 0)
    return {{"load_factor", nullptr}, {"new_area", nullptr}, {"time", nullptr}};
  return {{"load_factor", path[state].factor}, {"new_area", path[state].area}, {"time", path[state].time}};
}

/// What follows the state from which G rises as cracks grow.
std::string afterInstability(const std::optional<double>& motionFrom)
{
  if (motionFrom.value_or(-1.0) >= 0.0)
    return ". From there on the run is dynamic";
  return ". What is released above the toughness becomes motion in a real body; "
         "here it is missing from the energy balance";
}

/// From when on the run is one of motion.
nlohmann::json entryOfMotion(const std::vector<PathState>& path, double motionFrom)
{
  if (motionFrom < 0.0 || path.empty())
    return {{"new_area", nullptr}, {"time", nullptr}};
  return {{"new_area", path.back().area}, {"time", motionFrom}};
}

/// Of given loads: where G rises as cracks grow.
void reportGivenLoads(const std::vector<PathState>& path, const std::optional<double>& motionFrom,
                      nlohmann::json& summary)
{
  const auto rises =
      std::find_if(path.begin(), path.end(), [](const PathState& s) { return s.rise > noticeable; });
  nlohmann::json& entry = summary["propagation"];
  entry["initiation"] = {{"time", nullptr}, {"from", nullptr}, {"to", nullptr}};
  if (!path.empty())
  {
    const PathState& first = path.front();
    entry["initiation"] = {{"time", first.reached}, {"from", first.from}, {"to", first.time}};
    summary["answers"].push_back("cracks start at about t = " + readableTime(first.reached) +
                                 ", in the load step from " + readableTime(first.from) + " to " +
                                 readableTime(first.time) + effectOfShearOnFirst(summary));
  }
  entry["unstable_from"] = {{"new_area", nullptr}, {"time", nullptr}};
  if (rises != path.end())
    entry["unstable_from"] = {{"new_area", rises->area}, {"time", rises->time}};
  if (rises != path.end())
    summary["answers"].push_back("growth becomes unstable in the load step from " +
                                 readableTime(rises->from) + " to " + readableTime(rises->time) +
                                 ": G rises as the crack grows under the loads of that time, new "
                                 "area " +
                                 formatShort(rises->area) + " m2" + afterInstability(motionFrom));
  if (motionFrom)
    entry["motion_from"] = entryOfMotion(path, *motionFrom);
}

} // namespace

PathEvents eventsOf(const std::vector<PathState>& path)
{
  PathEvents events;
  const int count = static_cast<int>(path.size());
  for (int k = 0; k < count; ++k)
    if (events.largest < 0 || path[k].factor > path[events.largest].factor)
      events.largest = k;
  for (int k = 0; k + 1 < count; ++k)
  {
    if (events.falls < 0 && fallsAfter(path, k, &PathState::factor))
      events.falls = k;
    if (events.snapsBack < 0 && path[k].displacement > 0.0 && fallsAfter(path, k, &PathState::factor) &&
        fallsAfter(path, k, &PathState::displacement))
      events.snapsBack = k;
  }
  for (int k = events.falls + 1; events.falls >= 0 && k < count && events.again < 0; ++k)
    if (path[k].factor >= path[events.falls].factor)
      events.again = k;
  return events;
}

void reportPathOfEquilibrium(const std::vector<PathState>& path, bool hasFactor, nlohmann::json& summary,
                             const std::optional<double>& motionFrom)
{
  if (!hasFactor)
    return reportGivenLoads(path, motionFrom, summary);
  nlohmann::json& entry = summary["propagation"];
  if (path.empty()) // what will be there is known from the start
  {
    entry["load_factor"] = nullptr;
    for (const char* name : {"initiation", "largest_load", "unstable_from", "unstable_to", "snap_back_from"})
      entry[name] = entryOf(path, -1);
    return;
  }
  const PathEvents events = eventsOf(path);
  entry["load_factor"] = path.back().factor;
  entry["initiation"] = entryOf(path, 0);
  entry["largest_load"] = entryOf(path, events.largest);
  entry["unstable_from"] = entryOf(path, events.falls);
  entry["unstable_to"] = entryOf(path, events.again);
  entry["snap_back_from"] = entryOf(path, events.snapsBack);
  std::string text = "cracks start at " + formatShort(path.front().factor) +
                     " times the loads of Time > Final Time; the largest factor is " +
                     asText(path[events.largest]);
  text += effectOfShearOnFactor(path.front().factor, summary);
  if (events.falls < 0)
    text += path.size() > 1 ? "; growth is stable under these loads" : "";
  else
    text += "; growth is unstable from " + asText(path[events.falls]) + " on: at fixed loads the crack runs" +
            (events.again < 0 ? "" : " to " + asText(path[events.again]));
  if (events.snapsBack >= 0)
    text += "; from " + asText(path[events.snapsBack]) +
            " on the displacement of the loads falls, too (snap-back): the crack runs at fixed displacement";
  summary["answers"].push_back(text);
}

void storeGrowth(EquilibriumGrowth& growth, Archive& archive)
{
  const Archive::Group group(archive, "growth in equilibrium");
  archive("drive", growth.drive);
  archive("rate", growth.rate);
  archive("area", growth.area);
  constexpr std::size_t width = 7;
  std::vector<double> rows;
  for (const PathState& s : growth.path)
    rows.insert(rows.end(), {s.time, s.factor, s.displacement, s.area, s.rise, s.from, s.reached});
  archive("path", rows, width);
  growth.path.clear();
  for (std::size_t k = 0; k + width <= rows.size(); k += width)
    growth.path.push_back(
        {rows[k], rows[k + 1], rows[k + 2], rows[k + 3], rows[k + 4], rows[k + 5], rows[k + 6]});
}

} // namespace Rhegma::propagation
