#include "damping/Settling.hpp"

#include "archive/Archive.hpp"
#include "base/Decay.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Rhegma::damping
{

namespace
{

/// Times the time so far: what hardly decays in all of the run is a rigid motion that a small resultant
/// drives; it strains nothing.
constexpr double slowestDecay = 10.0;

/// As many as hold several periods of a body that settles.
constexpr std::size_t mostWatched = 400;

bool endsWith(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

} // namespace

void Settling::serialize(Archive& archive)
{
  std::vector<double> ratios, watched;
  std::vector<int> counts;
  for (const Sample& sample : last_)
  {
    ratios.push_back(sample.ratio);
    counts.push_back(static_cast<int>(sample.watched.size()));
    watched.insert(watched.end(), sample.watched.begin(), sample.watched.end());
  }
  archive("ratios", ratios);
  archive("counts", counts);
  archive("watched", watched);
  last_.clear();
  auto next = watched.begin();
  for (std::size_t k = 0; k < ratios.size(); next += counts[k++])
    last_.push_back({ratios[k], {next, next + counts[k]}});
  std::vector<double> motion;
  for (const auto& [time, kinetic] : motion_)
    motion.insert(motion.end(), {time, kinetic});
  archive("motion", motion, 2);
  motion_.clear();
  for (std::size_t k = 0; k + 1 < motion.size(); k += 2)
    motion_.emplace_back(motion[k], motion[k + 1]);
  int columns = watched_.empty() ? 0 : static_cast<int>(watched_.front().size());
  std::vector<double> series;
  for (const std::vector<double>& values : watched_)
    series.insert(series.end(), values.begin(), values.end());
  archive("columns", columns);
  archive("series", series);
  watched_.clear();
  for (auto at = series.begin(); columns > 0 && at != series.end(); at += columns)
    watched_.emplace_back(at, at + columns);
}

double Settling::mayStillChange() const
{
  double most = watched_.empty() ? std::numeric_limits<double>::quiet_NaN() : creep_;
  for (std::size_t k = 0; !watched_.empty() && k < watched_.back().size(); ++k)
  {
    std::vector<double> series;
    for (const std::vector<double>& values : watched_)
      series.push_back(values[k]);
    const double change = remainingChange(series);
    // Written so that what is not a number stays.
    if (const double fraction = change == 0.0 ? 0.0 : change / std::abs(series.back()); !(fraction <= most))
      most = fraction;
  }
  return most;
}

bool Settling::isSlow() const
{
  return last_.size() >= samples_ &&
         std::all_of(last_.begin(), last_.end(), [&](const Sample& s) { return s.ratio < ratio_; });
}

std::optional<double> Settling::decayTime() const
{
  constexpr double steady = 2.0; // ratio of the rates of decay in the two halves
  if (motion_.size() < std::max<std::size_t>(samples_, 2))
    return std::nullopt;
  const std::size_t last = motion_.size() - 1,
                    back = std::max(motion_.size() / 4, std::max<std::size_t>(samples_, 2) - 1);
  // Oscillations go up and down, and mixtures of motions decay at several rates.
  for (std::size_t k = last - back; k < last; ++k)
    if (!(motion_[k].second > motion_[k + 1].second))
      return std::nullopt;
  const auto& [before, earlier] = motion_[last - back];
  const auto& [halfway, between] = motion_[last - back / 2];
  const auto& [now, kinetic] = motion_.back();
  if (!(kinetic > 0.0))
    return std::nullopt;
  const double first = std::log(earlier / between) / (halfway - before),
               second = std::log(between / kinetic) / (now - halfway);
  if (std::max(first, second) > steady * std::min(first, second))
    return std::nullopt;
  return 2.0 * (now - before) / std::log(earlier / kinetic);
}

std::optional<double> Settling::frequencyOfCreep() const
{
  constexpr double creeps = 4.0;
  const std::optional<double> s = decayTime();
  if (!s || !(massDamping_ * *s > creeps) || !(*s < slowestDecay * motion_.back().first))
    return std::nullopt;
  return std::sqrt((massDamping_ - 1.0 / *s) / *s);
}

double Settling::creep(double strain) const
{
  constexpr double strong = 50.0; // r s; it is 2 at critical damping and 50 at 3.5 times that
  const std::optional<double> s = decayTime();
  if (!s || !(massDamping_ > 0.0) || !(strain > 0.0))
    return 0.0;
  const double rs = massDamping_ * *s;
  return rs > strong && *s < slowestDecay * motion_.back().first
             ? 2.0 * std::sqrt(motion_.back().second * rs / strain)
             : 0.0;
}

void Settling::forget()
{
  last_.clear();
  motion_.clear();
  watched_.clear();
}

bool Settling::sample(double kinetic, double strain, const HistoryRow& row, double time)
{
  constexpr double most = 100.0; // times the drift, which is of a few samples
  if (time < loadsChangeUntil_)
  {
    forget();
    return false;
  }
  motion_.emplace_back(time, kinetic);
  if (motion_.size() > mostWatched)
    motion_.pop_front();
  creep_ = creep(strain);
  Sample now;
  now.ratio = strain > 0.0 ? kinetic / strain : std::numeric_limits<double>::infinity();
  for (const auto& [name, value] : row)
    // Crack closure is not a number where faces are several cells apart.
    if (endsWith(name, ".G_J") || (endsWith(name, ".G_closure") && std::isfinite(value)))
      now.watched.push_back(value);
  if (now.watched.empty())
    now.watched.push_back(strain);
  if (!watched_.empty() && watched_.back().size() != now.watched.size())
    watched_.clear();
  watched_.push_back(now.watched);
  if (watched_.size() > mostWatched)
    watched_.pop_front();
  last_.push_back(now);
  if (last_.size() > samples_)
    last_.pop_front();
  if (last_.size() < samples_ || creep_ > most * drift_)
    return false;
  if (loadsChangeUntil_ > 0.0 && time < loadsChangeUntil_ + answer_)
    return false;
  for (const Sample& sample : last_)
  {
    if (!(sample.ratio < ratio_) || sample.watched.size() != now.watched.size())
      return false;
    for (std::size_t k = 0; k < now.watched.size(); ++k)
      if (!(std::abs(sample.watched[k] - now.watched[k]) <= drift_ * std::abs(now.watched[k])))
        return false;
  }
  return true;
}

} // namespace Rhegma::damping
