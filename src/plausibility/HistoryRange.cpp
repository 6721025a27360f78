#include "plausibility/HistoryRange.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace Rhegma
{

namespace
{

/// A time that is looked at.
struct Looked
{
  double time;
  bool acts; ///< whether the loads of this time count
};

/// In order; those of the ends of load steps are exactly those of the steps.
std::vector<Looked> timesOf(const std::vector<double>& corners, const ActingTimes& times)
{
  const int pieces = corners.empty() ? 4096 : 256;
  const bool all = times.steps == 0;
  std::vector<Looked> looked;
  for (int k = 0; k <= pieces; ++k)
    looked.push_back({times.end * k / pieces, all});
  for (const double corner : corners)
    if (corner > 0.0 && corner < times.end)
      looked.push_back({corner, all});
  for (int k = 1; k <= times.steps; ++k)
    looked.push_back({times.end * k / times.steps, true});
  std::sort(looked.begin(), looked.end(), [](const Looked& a, const Looked& b) { return a.time < b.time; });
  return looked;
}

} // namespace

HistoryRange rangeOf(const std::function<double(double)>& function, const std::vector<double>& corners,
                     const ActingTimes& times)
{
  HistoryRange range;
  double integral = 0.0, before = function(0.0), last = 0.0;
  for (const Looked& looked : timesOf(corners, times))
  {
    const double now = function(looked.time), dt = looked.time - last, former = integral;
    integral += 0.5 * (before + now) * dt;
    range.twice += 0.5 * (former + integral) * dt;
    range.largest = std::max(range.largest, std::fabs(now));
    range.integral = std::max(range.integral, std::fabs(integral));
    if (looked.acts)
    {
      range.acting = std::max(range.acting, std::fabs(now));
      range.actingIntegral = std::max(range.actingIntegral, std::fabs(integral));
    }
    before = now;
    last = looked.time;
  }
  return range;
}

HistoryRange rangeOf(const std::string& history, const ActingTimes& times)
{
  constexpr std::size_t most = 65536; // some megabytes
  thread_local std::map<std::tuple<std::string, double, int>, HistoryRange> kept;
  const auto key = std::make_tuple(history, times.end, times.steps);
  if (const auto at = kept.find(key); at != kept.end())
    return at->second;
  const TimeFunction f = TimeFunction::parse(history);
  const HistoryRange range = rangeOf([&f](double t) { return f(t); }, f.corners(), times);
  if (kept.size() >= most)
    kept.clear();
  kept.emplace(key, range);
  return range;
}

} // namespace Rhegma
