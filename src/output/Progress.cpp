#include "output/Progress.hpp"

#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

namespace Rhegma
{

namespace
{

constexpr double secondsBetweenPrints = 0.25;

/// When a run that is not watched on a terminal says for the first time how long it takes [s].
constexpr double secondsToFirstPrint = 2.0;

/// Between two lines within a load step, on a terminal and elsewhere [s].
constexpr double secondsOfIteration = 2.0, secondsOfIterationInFile = 30.0;

double wallClock()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::string duration(double seconds)
{
  const long all = std::lround(std::ceil(seconds * (1.0 - 1e-9)));
  char text[48];
  if (all >= 3600)
    std::snprintf(text, sizeof text, "%ld h %02ld min", all / 3600, all / 60 % 60);
  else if (all >= 60)
    std::snprintf(text, sizeof text, "%ld min %02ld s", all / 60, all % 60);
  else
    std::snprintf(text, sizeof text, "%ld s", all);
  return text;
}

} // namespace

Progress::Progress(std::ostream* stream, double finalTime, bool terminal)
    : Progress(stream, finalTime, terminal, wallClock)
{
}

Progress::Progress(std::ostream* stream, double finalTime, bool terminal, Clock clock)
    : stream_(stream),
      finalTime_(finalTime),
      terminal_(terminal),
      clock_(std::move(clock)),
      startClock_(clock_()),
      lastPrint_(startClock_),
      lastIteration_(startClock_)
{
}

void Progress::sample(double time, const Row& row)
{
  if (rest_ && time >= notBefore_)
    rest_->sample(time, row);
  releases_ = releasesOf(row);
  if (showsExtents_)
    extents_ = extentsOf(row);
  residual_ = residualFraction(row);
}

void Progress::followPace(double now)
{
  if (newer_.clock > 0.0 && now - newer_.clock <= 0.25 * (now - startClock_))
    return;
  older_ = newer_.clock > 0.0 ? newer_ : Mark{startClock_, startTime_};
  newer_ = {now, time_};
}

/// Text with a comma before it; empty where nothing is known.
std::string Progress::timeLeft() const
{
  const double gone = time_ - older_.time;
  if (!(gone > 0.0))
    return {};
  const double pace = (clock_() - older_.clock) / gone;
  const double toEnd = pace * (finalTime_ - time_), toRest = rest_ ? pace * rest_->left() : toEnd;
  if (!(toEnd > 0.0))
    return {};
  if (!rest_)
    return ", " + duration(toEnd) + " left";
  return toRest < toEnd ? ", about " + duration(toRest) + " to rest"
                        : ", at most " + duration(toEnd) + " left";
}

/// Text with a comma before it: of each front, or of many the largest; empty where none is known.
std::string Progress::releaseText() const
{
  constexpr std::size_t few = 4;
  if (releases_.empty())
    return {};
  std::vector<double> shown = releases_;
  if (shown.size() > few)
    shown = {*std::max_element(shown.begin(), shown.end())};
  std::string text = toughness_ ? ", G/Gc " : ", G ";
  for (std::size_t k = 0; k < shown.size(); ++k)
  {
    char number[32];
    std::snprintf(number, sizeof number, toughness_ ? "%.3g" : "%.5g", shown[k] / toughness_.value_or(1.0));
    text += (k == 0 ? "" : ", ") + std::string(number);
  }
  text += toughness_ ? "" : " J/m2";
  return text + (releases_.size() > few ? " at most of " + std::to_string(releases_.size()) + " fronts" : "");
}

/// Text with a comma before it: of each crack, or of many the largest; empty where none is known.
std::string Progress::extentText() const
{
  constexpr std::size_t few = 4;
  if (extents_.sizes.empty())
    return {};
  std::vector<double> shown = extents_.sizes;
  if (shown.size() > few)
    shown = {*std::max_element(shown.begin(), shown.end())};
  std::string text = extents_.areAreas ? ", crack area " : ", crack ";
  for (std::size_t k = 0; k < shown.size(); ++k)
    text +=
        (k == 0 ? "" : ", ") + (extents_.areAreas ? formatShort(1e6 * shown[k]) : readableLength(shown[k]));
  text += extents_.areAreas ? " mm2" : "";
  return text + (extents_.sizes.size() > few ? " at most" : "");
}

std::string Progress::text(bool running) const
{
  char part[64];
  std::snprintf(part, sizeof part, "%3d %%", static_cast<int>(100.0 * done() + 1.0e-9));
  std::string text = part;
  if (running)
    text += timeLeft();
  text += ", step " + std::to_string(step_);
  text += releaseText() + extentText();
  if (residual_)
  {
    std::snprintf(part, sizeof part, ", residual %.2g %%", 100.0 * std::fabs(*residual_));
    text += part;
  }
  return text;
}

void Progress::print(bool running)
{
  write(text(running));
  stale_ = false;
}

void Progress::write(std::string text)
{
  if (terminal_)
  {
    const std::size_t width = text.size();
    text.resize(std::max(width, width_), ' ');
    width_ = width;
    *stream_ << '\r' << text;
    open_ = true;
  }
  else
    *stream_ << text << '\n';
  stream_->flush();
}

void Progress::iteration(long step, int iteration, double residual)
{
  const double now = clock_();
  if (stream_ == nullptr ||
      now - lastIteration_ < (terminal_ ? secondsOfIteration : secondsOfIterationInFile))
    return;
  lastIteration_ = now;
  char text[64];
  std::snprintf(text, sizeof text, "iteration %d, residual %.1e", iteration + 1, residual);
  write((step > 0 ? "load step " + std::to_string(step) + ": " : std::string()) + text);
  stale_ = true;
}

void Progress::step(double time, long step)
{
  if (stream_ == nullptr && !followed_)
    return;
  if (!begun_)
  {
    // The first step gives the begin of a continued run.
    begun_ = true;
    if (step > 1)
      startTime_ = time;
    lastTenth_ = static_cast<int>(10.0 * startTime_ / finalTime_ + 1.0e-9);
  }
  const double now = clock_();
  lastIteration_ = now;
  time_ = time;
  step_ = step;
  stale_ = true;
  followPace(now);
  if (stream_ == nullptr)
    return;
  if (terminal_)
  {
    if (now - lastPrint_ < secondsBetweenPrints)
      return;
    lastPrint_ = now;
    print(true);
    return;
  }
  const int tenth = static_cast<int>(10.0 * time / finalTime_ + 1.0e-9);
  const bool early = !early_ && time < finalTime_ && now - startClock_ >= secondsToFirstPrint;
  if (tenth <= lastTenth_ && !early)
    return;
  early_ = true;
  lastTenth_ = tenth;
  print(true);
}

void Progress::finish()
{
  if (stream_ == nullptr)
    return;
  // A run may end before its final time; then no time is left.
  if (stale_ && (terminal_ || time_ < finalTime_))
    print(false);
  if (open_)
    *stream_ << '\n' << std::flush;
  open_ = false;
}

} // namespace Rhegma
