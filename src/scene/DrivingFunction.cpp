#include "scene/DrivingFunction.hpp"

#include "scene/TimeFunction.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace Rhegma
{

namespace
{

constexpr int pieces = 4096;

/// A function does not settle that changes noticeably in the last tenth of a run, and by any more than
/// rounding at its end: in a thousandth, which a jump may leave to it.
constexpr double lateFraction = 0.1, endFraction = 1e-3, rounding = 1e-6;

bool isZero(const Teuchos::ParameterList& list, const std::string& parameter)
{
  if (parameter.empty() || !list.isType<Teuchos::Array<double>>(parameter))
    return false;
  const auto& values = list.get<Teuchos::Array<double>>(parameter);
  return std::all_of(values.begin(), values.end(), [](double v) { return v == 0.0; });
}

void collect(const Teuchos::ParameterList& list, const Section& section, const std::string& where,
             std::vector<DrivingFunction>& found)
{
  const std::string before = where.empty() ? "" : where + " > ";
  for (const Parameter& p : section.parameters)
    if (p.type == ParameterType::TimeFunction && list.isType<std::string>(p.name) &&
        !isZero(list, p.scalesRate))
      found.push_back({before + p.name, list.get<std::string>(p.name), !p.scalesRate.empty()});
  if (!section.key.empty() && list.isType<std::string>(section.key))
    if (const Section* const variant = section.findVariant(list.get<std::string>(section.key)))
      collect(list, *variant, where, found);
  for (auto entry = list.begin(); entry != list.end(); ++entry)
  {
    const std::string& name = list.name(entry);
    if (!list.isSublist(name))
      continue;
    if (const Section* const fixed = section.findSection(name))
      collect(list.sublist(name), *fixed, before + name, found);
    else if (section.userNamed())
      collect(list.sublist(name), section.entry.front(), before + name, found);
  }
}

/// Equally spaced, and the corners.
std::vector<double> timesOf(const std::vector<double>& corners, double end)
{
  std::vector<double> times;
  for (int k = 0; k <= pieces; ++k)
    times.push_back(end * k / pieces);
  for (const double corner : corners)
    if (corner > 0.0 && corner < end)
      times.push_back(corner);
  std::sort(times.begin(), times.end());
  return times;
}

std::vector<double> integralOf(const std::vector<double>& times, const std::vector<double>& values)
{
  std::vector<double> integral(values.size(), 0.0);
  for (std::size_t k = 1; k < values.size(); ++k)
    integral[k] = integral[k - 1] + 0.5 * (values[k - 1] + values[k]) * (times[k] - times[k - 1]);
  return integral;
}

/// The time from which on values stay within a tolerance of the last one.
double lastChange(const std::vector<double>& times, const std::vector<double>& values, double tolerance)
{
  std::size_t k = values.size() - 1;
  while (k > 0 && std::fabs(values[k - 1] - values.back()) <= tolerance)
    --k;
  return times[k];
}

bool settles(const std::vector<double>& times, const std::vector<double>& values)
{
  const double end = times.back();
  return lastChange(times, values, noticeableChange) < (1.0 - lateFraction) * end ||
         lastChange(times, values, rounding) < (1.0 - endFraction) * end;
}

} // namespace

std::vector<DrivingFunction> drivingFunctions(const Teuchos::ParameterList& scene, const SceneSchema& schema)
{
  std::vector<DrivingFunction> found;
  collect(scene, schema.root(), "", found);
  return found;
}

Changes::Changes(const std::vector<DrivingFunction>& functions, double end)
{
  std::set<std::pair<std::string, bool>> known; // many loads have the same history
  for (const DrivingFunction& driving : functions)
  {
    if (!known.emplace(driving.text, driving.ofRate).second)
      continue;
    const TimeFunction f = TimeFunction::parse(driving.text);
    Series series{driving.where, driving.ofRate, timesOf(f.corners(), end), {}};
    double largest = 0.0;
    for (const double time : series.times)
      series.values.push_back(f(time));
    if (driving.ofRate)
      series.values = integralOf(series.times, series.values);
    for (const double value : series.values)
      largest = std::max(largest, std::fabs(value));
    if (!(largest > 0.0) || !std::isfinite(largest))
      continue;
    for (double& value : series.values)
      value /= largest;
    const double change = lastChange(series.times, series.values, noticeableChange);
    if (!(change > 0.0))
      continue;
    if (settles(series.times, series.values))
      last_ = std::max(last_, change);
    all_.push_back(std::move(series));
  }
}

Changes::Change Changes::after(double time) const
{
  Change most;
  for (const Series& series : all_)
  {
    const auto from = std::lower_bound(series.times.begin(), series.times.end(), time) - series.times.begin();
    for (std::size_t k = static_cast<std::size_t>(from); k < series.values.size(); ++k)
      if (const double change = std::fabs(series.values[k] - series.values[static_cast<std::size_t>(from)]);
          change > most.fraction)
        most = {change, series.where, series.ofRate};
  }
  return most;
}

} // namespace Rhegma
