#include "base/Decay.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Rhegma
{

namespace
{

/// Of fewer values nothing is said.
constexpr std::size_t fewest = 12;

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Over how much of its last quarters a series goes one way only, if it approaches its limit and does not
/// oscillate about it.
constexpr double oneWay = 0.95;

/// Values from one number to another, both included.
struct Window
{
  Window(const std::vector<double>& values, std::size_t first, std::size_t last)
      : range(*std::max_element(values.begin() + first, values.begin() + last + 1) -
              *std::min_element(values.begin() + first, values.begin() + last + 1)),
        monotone(std::fabs(values[last] - values[first]) >= oneWay * range)
  {
  }
  double range;
  bool monotone;
};

double decayTime(double before, double now, double window, double limit)
{
  if (now <= limit)
    return 0.0;
  return now < 0.98 * before ? window * std::log(now / limit) / std::log(before / now) : infinite;
}

} // namespace

double remainingChange(const std::vector<double>& values)
{
  if (values.size() < fewest)
    return std::numeric_limits<double>::quiet_NaN();
  const std::size_t last = values.size() - 1, width = values.size() / 4;
  const Window before(values, last - 2 * width, last - width), now(values, last - width, last);
  const double decay = before.range > 0.0 ? std::min(1.0, now.range / before.range) : 1.0;
  // What follows in an approach is a geometric series; in an oscillation what comes first is the most: the
  // range in the middle between the last quarter and the next, since the period need not fit a quarter.
  const bool approach = before.monotone && now.monotone && decay < 0.99;
  return now.range * (approach ? decay / (1.0 - decay) : std::sqrt(decay));
}

double intervalsUntil(const std::vector<double>& values, double limit)
{
  if (values.size() < fewest)
    return infinite;
  const auto window = static_cast<std::ptrdiff_t>(values.size() / 4);
  const auto middle = values.end() - window;
  return decayTime(*std::max_element(middle - window, middle), *std::max_element(middle, values.end()),
                   static_cast<double>(window), limit);
}

double intervalsUntilStill(const std::vector<double>& values, double fraction)
{
  if (values.size() < fewest)
    return infinite;
  const auto window = static_cast<std::ptrdiff_t>(values.size() / 4);
  const auto middle = values.end() - window;
  const auto range = [](auto from, auto to)
  {
    const auto [least, most] = std::minmax_element(from, to);
    return *most - *least;
  };
  return decayTime(range(middle - window, middle), range(middle, values.end()), static_cast<double>(window),
                   fraction * std::fabs(values.back()));
}

} // namespace Rhegma
