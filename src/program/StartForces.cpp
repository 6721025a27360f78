#include "program/StartForces.hpp"

#include "base/ShortNumber.hpp"
#include "program/CompareRuns.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace Rhegma::program
{

namespace
{

using nlohmann::json;

/// A number of a path in a summary; not a number where there is none.
double numberAt(const json& summary, const char* object, const char* name)
{
  const json of = summary.value(object, json::object());
  return of.is_object() && of.contains(name) && of[name].is_number()
             ? of[name].get<double>()
             : std::numeric_limits<double>::quiet_NaN();
}

/// When the first crack starts, of a run whose loads are those of its history [s].
double startTime(const json& summary)
{
  const json growth = summary.value("propagation", json::object());
  const json first = growth.value("initiation", json::object());
  if (first.is_object() && first.contains("load_factor"))
    return numberAt(growth, "initiation", "time");
  double time = std::numeric_limits<double>::quiet_NaN();
  for (const json& crack : summary.value("cracks", json::array()))
    for (const json& front : crack.value("fronts", json::array()))
      if (front.is_object() && front.contains("time_of_toughness") && front["time_of_toughness"].is_number())
        time = std::fmin(time, front["time_of_toughness"].get<double>());
  return time;
}

/// A column of a history at a time, on straight lines between rows; not a number outside of them.
double columnAt(const HistoryColumns& history, const std::string& name, double time)
{
  constexpr double rounding = 1e-9; // of times that were written with all digits
  const auto times = history.find("time"), values = history.find(name);
  if (times == history.end() || values == history.end())
    return std::numeric_limits<double>::quiet_NaN();
  const std::vector<double>&t = times->second, &v = values->second;
  for (std::size_t k = 0; k < std::min(t.size(), v.size()); ++k)
  {
    if (std::fabs(t[k] - time) <= rounding * std::fabs(time))
      return v[k];
    if (k > 0 && t[k - 1] < time && time < t[k])
      return v[k - 1] + (time - t[k - 1]) / (t[k] - t[k - 1]) * (v[k] - v[k - 1]);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

/// The forces of all loads and supports. \param force of one, its name and an axis: not a number where there
/// is none
json forcesOf(const json& summary, const std::function<double(const json&, const std::string&, int)>& force)
{
  json forces = json::object();
  for (const json& one : summary.value("boundaries", json::array()))
  {
    if (!one.contains("force") || !one["force"].is_array())
      continue;
    const std::string name = one.value("name", std::string());
    json components = json::array();
    bool any = false;
    for (std::size_t d = 0; d < one["force"].size(); ++d)
    {
      const double value = force(one["force"], name, static_cast<int>(d));
      components.push_back(std::isfinite(value) ? json(value) : json());
      any = any || std::isfinite(value);
    }
    if (any)
      forces[name] = components;
  }
  return forces;
}

std::string readableForce(double newtons)
{
  return newtons >= 1e6   ? formatShort(1e-6 * newtons) + " MN"
         : newtons >= 1e3 ? formatShort(1e-3 * newtons) + " kN"
                          : formatShort(newtons) + " N";
}

double sizeOf(const json& force)
{
  double square = 0.0;
  for (const json& component : force)
    square += component.is_number() ? std::pow(component.get<double>(), 2) : 0.0;
  return std::sqrt(square);
}

} // namespace

void addStartForces(json& summary, const std::string& history)
{
  if (!summary.contains("equilibrium"))
    return;
  json forces = json::object();
  if (const double factor = numberAt(summary, "start_of_growth", "factor_at_end"); std::isfinite(factor))
    forces = forcesOf(summary,
                      [&](const json& force, const std::string&, int d)
                      {
                        return force[d].is_number() ? factor * force[d].get<double>()
                                                    : std::numeric_limits<double>::quiet_NaN();
                      });
  else if (const double time = startTime(summary); std::isfinite(time))
  {
    const HistoryColumns columns = readHistory(history);
    forces = forcesOf(summary, [&](const json&, const std::string& name, int d)
                      { return columnAt(columns, name + ".force_" + std::string(1, "xyz"[d]), time); });
  }
  if (!forces.empty())
    summary["forces_at_start"] = forces;
}

std::string startForcesAsText(const json& summary)
{
  constexpr double least = 0.01;  // of the largest: what is less is the reaction of a guide
  constexpr std::size_t most = 4; // that are named
  std::vector<std::pair<std::string, double>> sizes;
  double largest = 0.0;
  const json forces = summary.value("forces_at_start", json::object());
  for (const auto& [name, force] : forces.items())
  {
    sizes.emplace_back(name, sizeOf(force));
    largest = std::max(largest, sizes.back().second);
  }
  std::stable_sort(sizes.begin(), sizes.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::string text;
  std::size_t count = 0;
  for (const auto& [name, size] : sizes)
    if (size > least * largest && ++count <= most)
      text += (count > 1 ? ", " : "") + name + " " + readableForce(size);
  return count == 0 ? std::string()
                    : "forces as the first crack starts: " + text +
                          (count > most ? " and " + std::to_string(count - most) + " more" : "");
}

} // namespace Rhegma::program
