#include "program/CompareRuns.hpp"

#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"

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

constexpr double noNumber = std::numeric_limits<double>::quiet_NaN();

/// Change of an answer that counts as resolved.
constexpr double resolvedChange = 0.05;

/// A stress intensity below this fraction of the largest of its front is as good as zero.
constexpr double smallIntensity = 0.02;

/// No extrapolation from a larger change: cells are too large for an order to hold.
constexpr double largestExtrapolated = 0.25;

double numberOrNone(const json& object, const char* name)
{
  const auto at = object.find(name);
  return at != object.end() && at->is_number() ? at->get<double>() : noNumber;
}

std::string cellsText(double cells) { return formatShort(cells) + (cells == 1.0 ? " cell" : " cells"); }

/// Collects answers of both runs.
class Comparison
{
public:
  explicit Comparison(double cell) : cell_(cell) {}

  /// \param order of the error in the size of the cells; 0: not smooth, so not extrapolated. Nor are answers
  /// of runs that stopped.
  void value(const std::string& name, const std::string& unit, double asIs, double half, int order)
  {
    if (std::isnan(asIs) && std::isnan(half))
      return;
    json answer = {{"name", name}, {"unit", unit}, {"as_is", asIs}, {"half", half}};
    if (asIs == 0.0 && half == 0.0)
    {
      answer["change"] = 0.0;
      answer["resolved"] = false;
      answer["verdict"] = "zero in both: nothing to resolve";
      return answers_.push_back(std::move(answer));
    }
    known_ = true;
    if (std::isnan(asIs) || std::isnan(half))
      return add(answer, false,
                 std::isnan(asIs) ? "none in the scene as it is" : "none with half the cell size");
    const double scale = std::max(std::fabs(half), std::numeric_limits<double>::min());
    const double change = asIs == half ? 0.0 : (half - asIs) / scale;
    answer["change"] = change;
    if (order > 0 && !stopped_ && std::fabs(change) <= largestExtrapolated)
    {
      answer["order"] = order;
      answer["extrapolated"] = half + (half - asIs) / (std::pow(2.0, order) - 1.0);
    }
    add(answer, std::fabs(change) <= resolvedChange, "moves by " + formatShort(100.0 * change) + " %");
  }

  /// \param distance [m]
  void distance(const std::string& name, double distance)
  {
    if (std::isnan(distance))
      return;
    known_ = true;
    const double cells = distance / cell_;
    add({{"name", name}, {"unit", "m"}, {"distance", distance}, {"cells", cells}}, cells <= 1.0,
        "differs by " + cellsText(cells));
  }

  void word(const std::string& name, const std::string& asIs, const std::string& half)
  {
    add({{"name", name}, {"unit", ""}, {"as_is", asIs}, {"half", half}}, asIs == half,
        asIs == half ? "the same" : "differs");
  }

  /// Of runs one of which stopped, or both: what comes after that is not known.
  void stops(bool asIs, bool half)
  {
    stopped_ = true;
    const auto text = [](bool stopped) { return stopped ? "stopped" : "finished"; };
    add({{"name", "end of the run"}, {"unit", ""}, {"as_is", text(asIs)}, {"half", text(half)}}, false,
        asIs == half ? "both stopped" : "differs");
    advice_ =
        asIs == half ? "see why the runs stopped"
        : asIs ? "the run finishes with half the cell size: use that size, and compare again with half of it"
               : "see why the run stops with half the cell size";
  }

  json result() const
  {
    const bool resolved = open_.empty() && known_;
    const std::string verdict =
        answers_.empty()           ? "nothing to compare: the scene has no crack, temperature or "
                                     "Reference"
        : open_.empty() && !known_ ? "nothing to compare: all answers are zero in both runs; see whether "
                                     "loads act, and come to the crack before Time > Final Time"
        : resolved                 ? "resolved: no answer moves by more than 5 %, no path or "
                                     "position by more than a cell"
                                   : "not resolved: " + open_ + "; " + advice_;
    return {{"answers", answers_},
            {"resolved", resolved},
            {"open", open_},
            {"verdict", verdict},
            {"cell", cell_}};
  }

private:
  void add(json answer, bool resolved, const std::string& what)
  {
    if (!resolved)
      open_ += (open_.empty() ? "" : "; ") + answer["name"].get<std::string>() + " (" + what + ")";
    answer["resolved"] = resolved && !stopped_;
    answer["verdict"] = what + (!resolved  ? ": not resolved"
                                : stopped_ ? ": not judged, as a run stopped"
                                           : ": resolved");
    answers_.push_back(std::move(answer));
  }

  double cell_; ///< smallest of the scene as it is [m]
  json answers_ = json::array();
  std::string open_; ///< answers that are not resolved, and what of them
  std::string advice_ = "use smaller cells";
  bool known_ = false;   ///< there is an answer that is not zero
  bool stopped_ = false; ///< then the runs end at different times
};

using Point = std::vector<double>;

Point position(const json& front)
{
  const auto at = front.find("position");
  return at != front.end() && at->is_array() && !at->empty() && at->front().is_number() ? at->get<Point>()
                                                                                        : Point();
}

double between(const Point& a, const Point& b)
{
  double sum = a.size() == b.size() && !a.empty() ? 0.0 : noNumber;
  for (std::size_t d = 0; d < std::min(a.size(), b.size()); ++d)
    sum += (a[d] - b[d]) * (a[d] - b[d]);
  return std::sqrt(sum);
}

/// From a point to a segment.
double toSegment(const Point& x, const Point& a, const Point& b)
{
  double along = 0.0, length = 0.0;
  for (std::size_t d = 0; d < x.size(); ++d)
  {
    along += (x[d] - a[d]) * (b[d] - a[d]);
    length += (b[d] - a[d]) * (b[d] - a[d]);
  }
  const double fraction = length > 0.0 ? std::clamp(along / length, 0.0, 1.0) : 0.0;
  Point nearest(x.size());
  for (std::size_t d = 0; d < x.size(); ++d)
    nearest[d] = a[d] + fraction * (b[d] - a[d]);
  return between(x, nearest);
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
  return path;
}

/// Largest distance of a point of the shorter path from the longer one: what lies beyond the shorter one's
/// end is a matter of how far the front came, not of where it went.
double betweenPaths(std::vector<Point> one, std::vector<Point> other)
{
  const auto length = [](const std::vector<Point>& path)
  {
    double sum = 0.0;
    for (std::size_t k = 1; k < path.size(); ++k)
      sum += between(path[k - 1], path[k]);
    return sum;
  };
  if (one.size() < 2 || other.size() < 2)
    return noNumber;
  if (length(one) > length(other))
    std::swap(one, other);
  double most = 0.0;
  for (const Point& x : one)
  {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 1; k < other.size(); ++k)
      least = std::min(least, toSegment(x, other[k - 1], other[k]));
    most = std::max(most, least);
  }
  return most;
}

std::string endOf(const json& front)
{
  if (front.value("ended", false))
    return "ended";
  if (front.value("stopped", false))
    return "stopped";
  if (!std::isfinite(numberOrNone(front, "initiated")))
    return "at rest";
  if (front.value("status", "") == "growing") // in equilibrium, where no front runs
    return "growing";
  return front.value("running", false) ? "running" : "arrested";
}

void compareAtRest(Comparison& comparison, const std::string& name, const json& asIs, const json& half)
{
  // A front among nodes acts as if the crack ended up to a quarter of a cell earlier: an error of the first
  // order (docs/accuracy-and-cost.md).
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

/// The growth of a run in equilibrium whose loads have a factor; null for other runs.
json initiationUnderFactor(const json& summary)
{
  const auto growth = summary.find("propagation");
  if (growth == summary.end() || !growth->is_object() || !growth->contains("load_factor"))
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

/// The load at which cracks start: where it is found, its time is the number of a load step and says nothing.
void compareInitiationLoads(Comparison& comparison, const RunResults& asIs, const RunResults& half)
{
  const json one = initiationUnderFactor(asIs.summary), other = initiationUnderFactor(half.summary);
  if (one.is_null() && other.is_null())
    return;
  const auto number = [](const json& entry, const char* name)
  { return entry.is_object() ? numberOrNone(entry, name) : noNumber; };
  comparison.value("load factor at initiation", "", number(one, "load_factor"), number(other, "load_factor"),
                   0);
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

void compareFront(Comparison& comparison, const std::string& name, const json& asIs, const json& half,
                  const RunResults& first, const RunResults& second)
{
  const std::string endAsIs = endOf(asIs), endHalf = endOf(half);
  comparison.word("end of " + name, endAsIs, endHalf);
  if (endAsIs == "at rest" && endHalf == "at rest")
    return compareAtRest(comparison, name, asIs, half);
  if (initiationUnderFactor(first.summary).is_null() || initiationUnderFactor(second.summary).is_null())
    comparison.value("initiation of " + name, "s", numberOrNone(asIs, "initiated"),
                     numberOrNone(half, "initiated"), 0);
  comparison.value("speed of " + name, "m/s", numberOrNone(asIs, "settled_speed"),
                   numberOrNone(half, "settled_speed"), 0);
  comparison.value("G of " + name + " while it runs", "J/m2", numberOrNone(asIs, "settled_release"),
                   numberOrNone(half, "settled_release"), 0);
  comparison.distance("path of " + name,
                      betweenPaths(pathOf(first.history, name), pathOf(second.history, name)));
  comparison.distance("last position of " + name, between(position(asIs), position(half)));
}

void compareTemperatures(Comparison& comparison, const json& asIs, const json& half)
{
  if (!asIs.contains("temperature") || !half.contains("temperature"))
    return;
  // Sources are resolved to the second order (docs/accuracy-and-cost.md).
  comparison.value("peak rise of temperature", "K", numberOrNone(asIs["temperature"], "peak_rise"),
                   numberOrNone(half["temperature"], "peak_rise"), 2);
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

/// Whether a run ended before its end.
bool isStopped(const json& run)
{
  const auto status = run.find("status");
  return status != run.end() && status->is_string() && status->get<std::string>().rfind("finished", 0) != 0;
}

void compareEnds(Comparison& comparison, const json& asIs, const json& half)
{
  if (!isStopped(asIs) && !isStopped(half))
    return;
  comparison.stops(isStopped(asIs), isStopped(half));
  comparison.value("time reached", "s", numberOrNone(asIs, "time"), numberOrNone(half, "time"), 0);
}

/// How and when a run ended.
json endOfRun(const json& summary)
{
  json end = json::object();
  for (const char* key : {"status", "time", "steps"})
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

std::string cellText(const json& value)
{
  if (value.is_number())
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
  compareInitiationLoads(comparison, asIs, half);
  compareTemperatures(comparison, asIs.summary, half.summary);
  compareReferences(comparison, asIs.summary, half.summary);
  json result = comparison.result();
  result["runs"] = {{"as_is", endOfRun(asIs.summary)}, {"half", endOfRun(half.summary)}};
  return result;
}

std::string comparisonAsText(const nlohmann::json& comparison)
{
  std::ostringstream text;
  char line[256];
  std::snprintf(line, sizeof line, "%-34s %12s %12s %12s  %s\n", "", "as it is", "half", "extrapolated", "");
  text << line;
  for (const json& answer : comparison.at("answers"))
  {
    const std::string unit = answer.at("unit");
    const std::string name = answer.at("name").get<std::string>() +
                             (unit.empty() || answer.contains("cells") ? "" : " [" + unit + "]");
    const json empty;
    const auto of = [&](const char* key) { return cellText(answer.contains(key) ? answer[key] : empty); };
    std::snprintf(line, sizeof line, "%-34s %12s %12s %12s  ", name.c_str(), of("as_is").c_str(),
                  of("half").c_str(), of("extrapolated").c_str());
    text << line << answer.at("verdict").get<std::string>()
         << (answer.contains("order") ? " (order " + std::to_string(answer["order"].get<int>()) + " assumed)"
                                      : "")
         << "\n";
  }
  const json& runs = comparison.at("runs");
  for (const auto& [name, title] : {std::pair("as_is", "As it is: "), std::pair("half", "With half: ")})
    if (isStopped(runs.at(name)))
      text << title << runs.at(name).at("status").get<std::string>() << "\n";
  text << "Verdict: " << comparison.at("verdict").get<std::string>() << "\n";
  return text.str();
}

} // namespace Rhegma::program
