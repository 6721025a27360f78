#include "propagation/FrontHistory.hpp"

#include "archive/Archive.hpp"

#include <algorithm>

namespace Rhegma::propagation
{

namespace
{

/// Fraction of a prediction of G by which it may be too low. Fronts that are sampled late advance late.
constexpr double safety = 0.05;

/// Upper bound of the increments in a step.
constexpr int mostIncrements = 16;

} // namespace

Advance FrontHistory::advance(const AdvanceRule& rule, double time, double release, double increment,
                              double fastest)
{
  const double begin = timeBefore_, releaseAtBegin = releaseBefore_;
  recordRelease(time, release);
  Advance made;
  if (time < rule.startTime)
    return made;
  const auto releaseAt = [&](double t)
  { return time > begin ? release + (time - t) / (time - begin) * (releaseAtBegin - release) : release; };
  if (!running_)
  {
    if (release < rule.initiation)
    {
      closest_ = times_.empty() ? std::max(closest_, release / rule.initiation) : closest_;
      return made;
    }
    const double rise = release - releaseAtBegin;
    const double fraction = rise > 0.0 ? std::min(1.0, (release - rule.initiation) / rise) : 0.0;
    last_ = std::max(time - fraction * (time - begin), rule.startTime);
    lastSpeed_ = 0.0;
    running_ = true;
    starts_.push_back(static_cast<int>(times_.size()));
    recordIncrement(last_, increment);
    made = {1, rule.initiation};
  }
  while (made.increments < mostIncrements)
  {
    const double least = increment / fastest;
    const double from = std::max(begin, last_ + least);
    if (from > time)
      break;
    const auto excess = [&](double t)
    { return releaseAt(t) - rule.toughness(increment / (t - last_), rule.temperature); };
    double at = from;
    if (excess(from) < 0.0)
    {
      if (excess(time) < 0.0)
        break;
      double low = from, high = time;
      for (int i = 0; i < 40; ++i)
      {
        const double middle = 0.5 * (low + high);
        (excess(middle) < 0.0 ? low : high) = middle;
      }
      at = high;
    }
    const double speed = increment / (at - last_), toughness = rule.toughness(speed, rule.temperature);
    made.toughness = (made.toughness * made.increments + toughness) / (made.increments + 1);
    ++made.increments;
    last_ = at;
    lastSpeed_ = speed;
    recordIncrement(at, increment);
  }
  increment_ = increment;
  if (made.increments == 0 && release < rule.arrest && hasAlmostStopped(time, fastest))
  {
    running_ = false;
    lastSpeed_ = 0.0;
    arrestRelease_ = release;
    arrestToughness_ = rule.arrest;
  }
  return made;
}

bool FrontHistory::wouldAdvance(const AdvanceRule& rule, double time, double release, double increment,
                                double fastest) const
{
  if (time < rule.startTime)
    return false;
  if (!running_)
    return release >= rule.initiation;
  const double from = std::max(timeBefore_, last_ + increment / fastest);
  if (from > time)
    return false;
  const double part = time > timeBefore_ ? (time - from) / (time - timeBefore_) : 0.0;
  const auto exceeds = [&](double at, double releaseThen)
  { return !(releaseThen < rule.toughness(increment / (at - last_), rule.temperature)); };
  return exceeds(from, release + part * (releaseBefore_ - release)) || exceeds(time, release);
}

bool FrontHistory::isDue(const AdvanceRule& rule, double time, double dt, double interval, double increment,
                         double fastest) const
{
  constexpr double rounding = 1e-9;
  const bool first = timeBefore_ == 0.0;
  if (first || !(interval > 0.0))
    return true;
  if (running_ && time + dt < (1.0 - rounding) * (last_ + increment / fastest))
    return false;
  return time - timeBefore_ >= (1.0 - rounding) * interval ||
         wouldAdvance(rule, time, (1.0 + safety) * (releaseBefore_ + rate_ * (time - timeBefore_)), increment,
                      fastest);
}

bool FrontHistory::wasHeld(const AdvanceRule& rule, double time, double release) const
{
  if (running_ || !times_.empty() || !(timeBefore_ < rule.startTime && rule.startTime <= time))
    return false;
  if (releaseBefore_ >= rule.initiation)
    return true;
  const double part = (rule.startTime - timeBefore_) / (time - timeBefore_);
  return releaseBefore_ + part * (release - releaseBefore_) >= rule.initiation;
}

void FrontHistory::advanceInEquilibrium(double time, double release, double increment)
{
  recordRelease(time, release);
  if (!running_)
    starts_.push_back(static_cast<int>(times_.size()));
  running_ = true;
  last_ = time;
  lastSpeed_ = 0.0;
  increment_ = increment;
  recordIncrement(time, increment);
}

void FrontHistory::recordAtRest(const AdvanceRule& rule, double time, double release)
{
  recordRelease(time, release);
  double& largest = hasStarted(time, rule.startTime) ? closest_ : early_;
  if (times_.empty())
    largest = std::max(largest, release / rule.initiation);
}

void FrontHistory::recordRelease(double time, double release)
{
  if (time > timeBefore_)
    rate_ = (release - releaseBefore_) / (time - timeBefore_);
  impulse_ += 0.5 * (time - timeBefore_) * (release + releaseBefore_);
  timeBefore_ = time;
  releaseBefore_ = release;
}

void FrontHistory::recordIncrement(double time, double increment)
{
  rate_ = 0.0; // G is now that of another position
  // Increments lie after the sample before.
  times_.push_back(time);
  lengths_.push_back(increment);
  impulses_.push_back(impulse_ - (timeBefore_ - time) * releaseBefore_);
}

bool FrontHistory::hasAlmostStopped(double time, double fastest) const
{
  constexpr double almost = 0.02;
  return !running_ || increment_ < almost * fastest * (time - last_);
}

double FrontHistory::meanSinceAdvance() const
{
  const double lasts = timeBefore_ - last_;
  return impulses_.empty() || !(lasts > 0.0) ? 0.0 : (impulse_ - impulses_.back()) / lasts;
}

double FrontHistory::speed(double time) const
{
  if (!running_)
    return 0.0;
  return time > last_ ? std::min(lastSpeed_, increment_ / (time - last_)) : lastSpeed_;
}

std::vector<CrackRun> FrontHistory::runs() const
{
  std::vector<CrackRun> all;
  for (std::size_t r = 0; r < starts_.size(); ++r)
  {
    const std::size_t end = r + 1 < starts_.size() ? starts_[r + 1] : times_.size();
    if (static_cast<std::size_t>(starts_[r]) == end) // motion has begun, but it has not advanced since
      continue;
    CrackRun run{times_[starts_[r]], times_[end - 1], 0.0};
    for (std::size_t k = starts_[r]; k < end; ++k)
      run.length += lengths_[k];
    all.push_back(run);
  }
  return all;
}

double FrontHistory::meanSpeed() const
{
  double length = 0.0, duration = 0.0;
  for (std::size_t r = 0; r < starts_.size(); ++r)
  {
    const std::size_t begin = starts_[r], end = r + 1 < starts_.size() ? starts_[r + 1] : times_.size();
    if (begin == end)
      continue;
    // The front makes its first increment when it initiates, in no time.
    for (std::size_t k = begin + 1; k < end; ++k)
      length += lengths_[k];
    duration += times_[end - 1] - times_[begin];
  }
  return duration > 0.0 ? length / duration : 0.0;
}

/// Its first increment and the one after its last.
std::pair<std::size_t, std::size_t> FrontHistory::longestRun() const
{
  std::pair<std::size_t, std::size_t> longest(0, 0);
  for (std::size_t r = 0; r < starts_.size(); ++r)
  {
    const std::size_t begin = starts_[r], end = r + 1 < starts_.size() ? starts_[r + 1] : times_.size();
    if (end - begin > longest.second - longest.first)
      longest = {begin, end};
  }
  return longest;
}

/// Increments with which the second half of the longest run begins and ends; the same where it is too short.
std::pair<std::size_t, std::size_t> FrontHistory::secondHalf() const
{
  const auto [begin, end] = longestRun();
  return end - begin < 4 ? std::make_pair(begin, begin) : std::make_pair(begin + (end - begin) / 2, end - 1);
}

std::pair<double, double> FrontHistory::settled() const
{
  const auto [from, to] = secondHalf();
  return from == to ? std::make_pair(0.0, 0.0) : std::make_pair(times_[from], times_[to]);
}

double FrontHistory::settledSpeed() const
{
  const auto [from, to] = secondHalf();
  if (from == to)
    return 0.0;
  double length = 0.0;
  for (std::size_t k = from + 1; k <= to; ++k)
    length += lengths_[k];
  return length / (times_[to] - times_[from]);
}

double FrontHistory::settledRelease() const
{
  const auto [from, to] = secondHalf();
  return from == to ? 0.0 : (impulses_[to] - impulses_[from]) / (times_[to] - times_[from]);
}

void FrontHistory::serialize(Archive& archive)
{
  archive("running", running_);
  archive("closest", closest_);
  archive("early", early_);
  archive("last", last_);
  archive("last_speed", lastSpeed_);
  archive("increment", increment_);
  archive("time_before", timeBefore_);
  archive("release_before", releaseBefore_);
  archive("rate", rate_);
  archive("arrest_release", arrestRelease_);
  archive("arrest_toughness", arrestToughness_);
  archive("impulse", impulse_);
  archive("times", times_);
  archive("lengths", lengths_);
  archive("impulses", impulses_);
  archive("starts", starts_);
}

} // namespace Rhegma::propagation
