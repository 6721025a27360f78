#include "output/RestForecast.hpp"

#include "base/Decay.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Rhegma
{

namespace
{

/// The decay of the last samples is what counts; older ones are forgotten, half of them at a time.
constexpr std::size_t mostSamples = 400;

} // namespace

void RestForecast::sample(double time, const Row& row)
{
  double kinetic = 0.0, strain = 0.0, release = std::numeric_limits<double>::quiet_NaN();
  for (const auto& [name, value] : row)
  {
    const bool isRelease = name.size() > 4 && name.compare(name.size() - 4, 4, ".G_J") == 0;
    if (name == "kinetic")
      kinetic = value;
    else if (name == "strain")
      strain = value;
    else if (isRelease && std::isnan(release))
      release = value;
  }
  interval_ = time - time_;
  time_ = time;
  if (!(strain > 0.0))
    return;
  if (ratios_.size() >= mostSamples)
    for (std::vector<double>* values : {&ratios_, &watched_})
      values->erase(values->begin(), values->begin() + mostSamples / 2);
  ratios_.push_back(kinetic / strain);
  watched_.push_back(std::isnan(release) ? strain : release);
}

double RestForecast::left() const
{
  return interval_ * std::max(intervalsUntil(ratios_, ratio_), intervalsUntilStill(watched_, drift_));
}

} // namespace Rhegma
