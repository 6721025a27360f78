#include "energy_release/LargestRelease.hpp"

#include "archive/Archive.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::energy_release
{

template <int D>
void LargestRelease::add(const std::vector<FrontSample<D>>& samples, double time)
{
  for (const FrontSample<D>& sample : samples)
  {
    const double release = sample.J.empty() ? FrontSample<D>::notYet : meanAlong(sample.front, sample.J);
    if (!std::isfinite(release))
      continue;
    const auto [peak, isNew] =
        peaks_.try_emplace({sample.front.crack, sample.front.number}, Peak{release, time});
    if (!isNew && release > peak->second.release)
      peak->second = {release, time};
  }
}

LargestRelease::Peak LargestRelease::of(int crack, int number) const
{
  const auto peak = peaks_.find({crack, number});
  return peak == peaks_.end() ? Peak{FrontSample<2>::notYet, FrontSample<2>::notYet} : peak->second;
}

double LargestRelease::ever() const
{
  double largest = 0.0;
  for (const auto& [front, peak] : peaks_)
    largest = std::max(largest, peak.release);
  return largest;
}

void LargestRelease::serialize(Archive& archive)
{
  constexpr std::size_t width = 4;
  std::vector<double> rows;
  for (const auto& [front, peak] : peaks_)
    rows.insert(rows.end(), {double(front.first), double(front.second), peak.release, peak.time});
  archive("largest_release", rows, width);
  peaks_.clear();
  for (std::size_t k = 0; k + width <= rows.size(); k += width)
    peaks_[{static_cast<int>(rows[k]), static_cast<int>(rows[k + 1])}] = {rows[k + 2], rows[k + 3]};
}

template void LargestRelease::add(const std::vector<FrontSample<2>>&, double);
template void LargestRelease::add(const std::vector<FrontSample<3>>&, double);

} // namespace Rhegma::energy_release
