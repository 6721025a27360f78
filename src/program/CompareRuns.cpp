#include "program/CompareRuns.hpp"

#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "program/CompareTemperatures.hpp"
#include "program/Comparison.hpp"
#include "program/GrowthInHistory.hpp"
#include "program/PathDistance.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <sstream>

namespace Rhegma::program
{

namespace
{

using nlohmann::json;

using Point = std::vector<double>;

/// A stress intensity below this fraction of the largest of its front is as good as zero.
constexpr double smallIntensity = 0.02;

Point position(const json& front)
{
  const auto at = front.find("position");
  return at != front.end() && at->is_array() && !at->empty() && at->front().is_number() ? at->get<Point>()
                                                                                        : Point();
}

std::vector<Point> pathOf(const HistoryColumns& history, const std::string& front)
{
  std::vector<Point> path;
  for (const char* axis : {".x", ".y", ".z"})
  {
    const auto column = history.find(front + axis);
    if (column == history.end())
      continue;
    path.resize(column->second.size());
    for (std::size_t k = 0; k < path.size(); ++k)
      path[k].push_back(column->second[k]);
  }
  // Rows of a history may lack a position.
  path.erase(
      std::remove_if(path.begin(), path.end(),
                     [](const Point& x)
                     { return !std::all_of(x.begin(), x.end(), [](double c) { return std::isfinite(c); }); }),
      path.end());
  return path;
}

std::string endOfFront(const json& front)
{
  // Without Propagation it has no status. The reason of a stop names places, which move with the cells.
  const std::string status = front.value("status", "at rest");
  return status.substr(0, status.find_first_of(":,"));
}

/// Whether what two runs have at their ends is of the same time, or of bodies at rest: a run that stopped in
/// the middle of its motion is not to be compared with one that went on.
bool endTogether(const RunResults& asIs, const RunResults& half)
{
  constexpr double same = 1e-3;
  const double one = numberOrNone(asIs.summary, "time"), other = numberOrNone(half.summary, "time");
  return std::max(endOf(asIs.summary), endOf(half.summary)) == RunEnd::Finished ||
         !(std::fabs(one - other) > same * std::max(one, other));
}

void compareAtRest(Comparison& comparison, const std::string& name, const json& asIs, const json& half)
{
  comparison.value("largest G_J of " + name, "J/m2", numberOrNone(asIs, "largest_G_J"),
                   numberOrNone(half, "largest_G_J"), 0);
  // A front among nodes acts as if the crack ended up to a quarter of a cell earlier: an error of the first
  // order (docs/explanation/verification/accuracy-and-cost.md). Where bending dominates, the order is nearer
  // to 2.
  for (const char* release : {"G_J", "G_closure"})
    comparison.value(std::string(release) + " of " + name, "J/m2", numberOrNone(asIs, release),
                     numberOrNone(half, release), 1);
  double largest = 0.0;
  for (const char* mode : {"K_I", "K_II", "K_III"})
    for (const json* front : {&asIs, &half})
      if (const double k = std::fabs(numberOrNone(*front, mode)); k > largest)
        largest = k;
  for (const char* mode : {"K_I", "K_II", "K_III"})
  {
    const double one = numberOrNone(asIs, mode), other = numberOrNone(half, mode);
    if (!(std::max(std::fabs(one), std::fabs(other)) < smallIntensity * largest))
      comparison.value(std::string(mode) + " of " + name, "Pa sqrt(m)", one, other, 1);
  }
}

/// When or at which factor cracks start in a run in equilibrium; null for other runs.
json initiationInEquilibrium(const json& summary)
{
  const auto growth = summary.find("propagation");
  if (growth == summary.end() || !growth->is_object())
    return nullptr;
  const auto initiation = growth->find("initiation");
  return initiation != growth->end() && initiation->is_object() ? *initiation : json(nullptr);
}

/// Of the first row of a history at a time; not a number where there is none.
double valueAt(const HistoryColumns& history, const std::string& column, double time)
{
  const auto times = history.find("time"), values = history.find(column);
  if (times == history.end() || values == history.end())
    return noNumber;
  const double near = 1e-9 * std::fabs(time);
  for (std::size_t k = 0; k < std::min(times->second.size(), values->second.size()); ++k)
    if (std::fabs(times->second[k] - time) <= near)
      return values->second[k];
  return noNumber;
}

/// The loads at the largest growth that both runs have. Increments are measured in cells, so that at the end
/// the cracks of the run with half the cells are shorter.
void compareLoadsOfGrowth(Comparison& comparison, const RunResults& asIs, const RunResults& half)
{
  const std::vector<double> one = growthOf(asIs.history), other = growthOf(half.history);
  const double growth = one.empty() || other.empty() ? 0.0 : std::min(one.back(), other.back());
  if (growth > 0.0)
    comparison.value("load factor at the same growth", "", factorAt(asIs.history, growth),
                     factorAt(half.history, growth), 0, 0.0,
                     {{"growth", growth}, {"unit_of_growth", growsByArea(asIs.history) ? "m2" : "m"}});
}

/// Whether growth was found under loads that have a factor: how far a front comes is then a matter of the
/// number of its increments.
bool growsByIncrements(const RunResults& asIs, const RunResults& half)
{
  const json one = initiationInEquilibrium(asIs.summary), other = initiationInEquilibrium(half.summary);
  return one.is_object() && other.is_object() && one.contains("load_factor") && other.contains("load_factor");
}

/// The load at which cracks start. Its factor where it has one: the time is then the number of a load step
/// and says nothing. Else the time within the load step.
void compareInitiationLoads(Comparison& comparison, const RunResults& asIs, const RunResults& half)
{
  const json one = initiationInEquilibrium(asIs.summary), other = initiationInEquilibrium(half.summary);
  if (one.is_null() && other.is_null())
    return;
  const auto number = [](const json& entry, const char* name)
  { return entry.is_object() ? numberOrNone(entry, name) : noNumber; };
  if (!(one.is_object() ? one : other).contains("load_factor"))
    return comparison.value("time at which cracks start", "s", number(one, "time"), number(other, "time"), 0);
  comparison.value("load factor at initiation", "", number(one, "load_factor"), number(other, "load_factor"),
                   0);
  compareLoadsOfGrowth(comparison, asIs, half);
  const std::string suffix = ".displacement";
  for (const auto& column : asIs.history)
  {
    const std::string& name = column.first;
    if (name.size() <= suffix.size() || name.compare(name.size() - suffix.size(), suffix.size(), suffix) != 0)
      continue;
    const double first = valueAt(asIs.history, name, number(one, "time"));
    const double second = valueAt(half.history, name, number(other, "time"));
    if (!std::isnan(first) && !std::isnan(second)) // samples may leave load steps out
      comparison.value(name.substr(0, name.size() - suffix.size()) + ", displacement at initiation", "m",
                       first, second, 0);
  }
}

/// Mean length of a time step of a run [s]; 0 where it is not known.
double meanStep(const json& summary)
{
  const double time = numberOrNone(summary, "time"), steps = numberOrNone(summary, "steps");
  return time > 0.0 && steps >= 1.0 ? time / steps : 0.0;
}

void compareFront(Comparison& comparison, const std::string& name, const json& asIs, const json& half,
                  const RunResults& first, const RunResults& second)
{
  const std::string endAsIs = endOfFront(asIs), endHalf = endOfFront(half);
  comparison.word("end of " + name, endAsIs, endHalf);
  if (std::isnan(numberOrNone(asIs, "initiated")) && std::isnan(numberOrNone(half, "initiated")))
    return endTogether(first, second) ? compareAtRest(comparison, name, asIs, half) : void();
  // Both runs got that far, or one that did not would have.
  const double start = numberOrNone(asIs, "initiated"), other = numberOrNone(half, "initiated");
  comparison.areOfEarlierTimes(std::isnan(start)   ? numberOrNone(first.summary, "time") >= other
                               : std::isnan(other) ? numberOrNone(second.summary, "time") >= start
                                                   : true);
  if (initiationInEquilibrium(first.summary).is_null() || initiationInEquilibrium(second.summary).is_null())
    comparison.value("initiation of " + name, "s", start, other, 0, meanStep(first.summary));
  comparison.areOfEarlierTimes(false);
  comparison.value("speed of " + name, "m/s", numberOrNone(asIs, "settled_speed"),
                   numberOrNone(half, "settled_speed"), 0);
  const auto settled = [](const json& front) // 0: too few increments for a mean
  {
    const double release = numberOrNone(front, "settled_release");
    return release > 0.0 ? release : noNumber;
  };
  comparison.value("G of " + name + " while it runs", "J/m2", settled(asIs), settled(half), 0);
  comparison.distance("path of " + name,
                      distanceBetweenPaths(pathOf(first.history, name), pathOf(second.history, name)));
  if (!growsByIncrements(first, second) && endTogether(first, second))
    comparison.distance("last position of " + name, distanceBetween(position(asIs), position(half)));
}

void compareReferences(Comparison& comparison, const json& asIs, const json& half)
{
  const json none = json::array();
  const json& one = asIs.contains("references") ? asIs["references"] : none;
  const json& other = half.contains("references") ? half["references"] : none;
  for (std::size_t k = 0; k < std::min(one.size(), other.size()); ++k)
    // Of a reference of zero, such as an energy that should not be lost, only its tolerance can be judged.
    if (numberOrNone(one[k], "reference") != 0.0)
      comparison.value("Reference > " + one[k].value("name", ""), "", numberOrNone(one[k], "value"),
                       numberOrNone(other[k], "value"), 0);
}

/// Whether the cells stopped a front of a run, which may have gone on without it.
bool hasStoppedFront(const json& run)
{
  const json none = json::array();
  for (const json& crack : run.contains("cracks") ? run["cracks"] : none)
    for (const json& front : crack.contains("fronts") ? crack["fronts"] : none)
      if (front.is_object() && front.value("stopped", false))
        return true;
  return false;
}

void compareEnds(Comparison& comparison, const json& asIs, const json& half)
{
  const auto ofFronts = [](const json& run)
  { return hasStoppedFront(run) ? RunEnd::Stopped : RunEnd::Finished; };
  if (const RunEnd one = endOf(asIs), other = endOf(half); std::max(one, other) != RunEnd::Finished)
  {
    comparison.ends("end of the run", one, other);
    comparison.value("time reached", "s", numberOrNone(asIs, "time"), numberOrNone(half, "time"), 0);
  }
  else if (hasStoppedFront(asIs) || hasStoppedFront(half))
    comparison.ends("fronts stopped by the cells", ofFronts(asIs), ofFronts(half));
}

/// How and when a run ended.
json endAndTime(const json& summary)
{
  json end = json::object();
  for (const char* key : {"end", "status", "time", "steps"})
    if (summary.contains(key))
      end[key] = summary[key];
  return end;
}

/// Names of the columns of a history; those with a comma are in quotes (RFC 4180).
std::vector<std::string> columnNames(const std::string& header)
{
  std::vector<std::string> names(1);
  bool quoted = false;
  for (std::size_t k = 0; k < header.size(); ++k)
    if (header[k] == '"' && quoted && k + 1 < header.size() && header[k + 1] == '"')
      names.back() += header[++k];
    else if (header[k] == '"')
      quoted = !quoted;
    else if (header[k] == ',' && !quoted)
      names.emplace_back();
    else
      names.back() += header[k];
  return names;
}

/// The limit, or, where the order is not known, the limits for orders 2 and 1.
std::string limitText(const json& answer)
{
  if (!answer.contains("extrapolated"))
    return "-";
  const std::string limit = formatShort(answer["extrapolated"].get<double>());
  return answer["order"] == 1 ? formatShort(answer["extrapolated_order_2"].get<double>()) + " to " + limit
                              : limit;
}

std::string orderText(const json& answer)
{
  if (!answer.contains("order"))
    return {};
  return answer["order"] == 1 ? " (limits of orders 2 and 1)" : " (limit of order 2)";
}

/// A text and blanks up to a width in characters: in UTF-8 a character has bytes 10xxxxxx after its first.
std::string padded(const std::string& text, std::size_t width)
{
  const auto characters = static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
  return text + std::string(characters < width ? width - characters : 0, ' ');
}

std::string cellText(const json& value)
{
  if (value.is_number() &&
      std::isfinite(value.get<double>())) // a run may have too few increments for an answer
    return formatShort(value.get<double>());
  return value.is_string() ? value.get<std::string>() : "-";
}

} // namespace

HistoryColumns readHistory(const std::string& path)
{
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  const std::vector<std::string> names = columnNames(line);
  HistoryColumns columns;
  while (std::getline(file, line))
  {
    std::istringstream row(line);
    std::string text;
    for (std::size_t k = 0; k < names.size() && std::getline(row, text, ','); ++k)
      columns[names[k]].push_back(parseReal(text).value_or(noNumber));
  }
  return columns;
}

nlohmann::json compareRuns(const RunResults& asIs, const RunResults& half)
{
  Comparison comparison(asIs.summary.contains("cells") ? numberOrNone(asIs.summary["cells"], "smallest")
                                                       : noNumber);
  compareEnds(comparison, asIs.summary, half.summary);
  const json none = json::array();
  const json& cracks = asIs.summary.contains("cracks") ? asIs.summary["cracks"] : none;
  const json& others = half.summary.contains("cracks") ? half.summary["cracks"] : none;
  if (cracks.size() != others.size())
    comparison.word("number of cracks", std::to_string(cracks.size()), std::to_string(others.size()));
  for (std::size_t c = 0; c < std::min(cracks.size(), others.size()); ++c)
  {
    const json& fronts = cracks[c].contains("fronts") ? cracks[c]["fronts"] : none;
    const json& theirs = others[c].contains("fronts") ? others[c]["fronts"] : none;
    const std::string crack = cracks[c].value("name", "");
    if (fronts.size() != theirs.size())
      comparison.word("fronts of " + crack, std::to_string(fronts.size()), std::to_string(theirs.size()));
    for (std::size_t f = 0; f < std::min(fronts.size(), theirs.size()); ++f)
      if (fronts[f].is_object() && theirs[f].is_object())
        compareFront(comparison, crack + "." + std::to_string(f), fronts[f], theirs[f], asIs, half);
  }
  comparison.areOfEarlierTimes(!initiationInEquilibrium(asIs.summary).is_null() &&
                               !initiationInEquilibrium(half.summary).is_null());
  compareInitiationLoads(comparison, asIs, half);
  comparison.areOfEarlierTimes(false);
  if (endTogether(asIs, half))
  {
    compareTemperatures(comparison, asIs.summary, half.summary);
    compareReferences(comparison, asIs.summary, half.summary);
  }
  json result = comparison.result();
  result["runs"] = {{"as_is", endAndTime(asIs.summary)}, {"half", endAndTime(half.summary)}};
  return result;
}

std::string comparisonAsText(const nlohmann::json& comparison)
{
  std::ostringstream text;
  char line[256];
  std::snprintf(line, sizeof line, "%-34s %12s %12s %22s\n", "", "as it is", "half", "extrapolated");
  text << line;
  for (const json& answer : comparison.at("answers"))
  {
    const std::string unit = answer.at("unit");
    const std::string name = answer.at("name").get<std::string>() +
                             (unit.empty() || answer.contains("cells") ? "" : " [" + unit + "]");
    const json empty;
    const auto of = [&](const char* key) { return cellText(answer.contains(key) ? answer[key] : empty); };
    std::snprintf(line, sizeof line, " %12s %12s %22s  ", of("as_is").c_str(), of("half").c_str(),
                  limitText(answer).c_str());
    text << padded(name, 34) << line << answer.at("verdict").get<std::string>() << orderText(answer) << "\n";
  }
  const json& runs = comparison.at("runs");
  for (const auto& [name, title] : {std::pair("as_is", "As it is: "), std::pair("half", "With half: ")})
    if (const RunEnd end = endOf(runs.at(name)); end != RunEnd::Finished)
      text << title << runs.at(name).at("status").get<std::string>()
           << (end == RunEnd::NotAtRest ? " before the bodies were at rest" : "") << "\n";
  text << "Verdict: " << comparison.at("verdict").get<std::string>() << "\n";
  return text.str();
}

} // namespace Rhegma::program
