#include "plausibility/IdleLoads.hpp"

#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "scene/TimeFunction.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma
{

namespace
{

/// Part of the full load below which a load does next to nothing, and below which it hardly acts.
constexpr double nextToNothing = 1e-3, hardlyAny = 0.2;

/// Part of the full load below which one at the times of equilibrium is not what the scene looks like.
constexpr double half = 0.5;

bool isZero(const Teuchos::ParameterList& list, const std::string& name)
{
  if (list.isType<double>(name))
    return list.get<double>(name) == 0.0;
  if (!list.isType<Teuchos::Array<double>>(name))
    return false;
  const auto& all = list.get<Teuchos::Array<double>>(name);
  return std::all_of(all.begin(), all.end(), [](double value) { return value == 0.0; });
}

/// What is at the times that count, and what between them.
std::vector<std::string> betweenTimes(const GivenLoad& load, const std::string& quantity, double acting,
                                      double largest, const std::string& unit, const ActingTimes& times)
{
  if (times.steps == 0 || !(acting < (times.scaled ? nextToNothing : half) * largest))
    return {};
  const std::string reaches = formatShort(largest) + unit, is = formatShort(acting) + unit;
  if (times.steps == 1)
    return {load.where + ": " + quantity + " reaches " + reaches + ", and is " + is +
            " at Time > Final Time = " + readableTime(times.end) +
            ", the only time at which loads count in this analysis, so this " + load.noun +
            (acting < nextToNothing * largest ? " does next to nothing" : " acts with only that") +
            "; choose a Final Time at which it acts"};
  return {load.where + ": " + quantity + " reaches " + reaches + " between load steps, and at most " + is +
          " at the ends of load steps, where equilibrium is found: use more Time > Load Steps than " +
          std::to_string(times.steps)};
}

bool isConstant(const std::string& history, double end)
{
  constexpr int times = 16;
  const TimeFunction f = TimeFunction::parse(history);
  for (int k = 1; k <= times; ++k)
    if (f(end * k / times) != f(0.0))
      return false;
  return true;
}

/// A factor that depends on time, of which a static analysis takes the last value.
std::vector<std::string> smallAtTheEnd(const GivenLoad& load, const std::string& history, double acting,
                                       const ActingTimes& times)
{
  if (times.steps != 1 || times.scaled || !(acting < half) || isConstant(history, times.end))
    return {};
  return {load.where + ": its factor is " + formatShort(acting) + " at Time > Final Time = " +
          readableTime(times.end) + ", the only time at which loads count in this analysis, so this " +
          load.noun + " acts with " + formatShort(acting) +
          " of its value; leave History out to have all of it, or choose another Final Time; load steps do "
          "not follow History (for that write Time > Analysis = Quasi-Static)"};
}

} // namespace

double largestEver(const std::string& function, double end)
{
  constexpr int decades = 9, times = 16; // each
  const TimeFunction f = TimeFunction::parse(function);
  double largest = 0.0, before = 0.0;
  for (int k = 0; k <= decades * times; ++k)
  {
    const double now = std::fabs(f(end * std::pow(10.0, double(k) / times)));
    if (k == (decades - 1) * times)
      before = largest;
    largest = std::isfinite(now) ? std::max(largest, now) : largest;
  }
  return largest > 1.01 * before ? 0.0 : largest;
}

std::vector<std::string> idleMessages(const GivenLoad& load, const Teuchos::ParameterList& list,
                                      const std::vector<std::string>& values, const ActingTimes& times)
{
  std::vector<std::string> messages;
  for (const std::string& value : values)
    if (isZero(list, value))
      messages.push_back(load.where + " > " + value + " is zero, so this " + load.noun + " does nothing");
  if (!list.isParameter("History"))
    return messages;
  const std::string history = list.get<std::string>("History");
  const HistoryRange range = rangeOf(history, times);
  const double largest = range.largest, ever = largestEver(history, times.end);
  const std::string where = load.where + " > History",
                    upTo = where + ": up to Time > Final Time = " + readableTime(times.end) +
                           " its factor is at most " + formatShort(largest);
  if (largest < nextToNothing)
    messages.push_back(upTo + ", so this " + load.noun + " does next to nothing; times are in seconds");
  else if (largest < hardlyAny * ever)
    messages.push_back(upTo + ", and it reaches " + formatShort(ever) +
                       " later: does the run end too early? Times are in seconds");
  else if (messages.empty())
  {
    messages = betweenTimes({where, load.noun}, "its factor", range.acting, largest, "", times);
    if (messages.empty())
      messages = smallAtTheEnd({where, load.noun}, history, range.acting, times);
  }
  return messages;
}

std::vector<std::string> idleMessages(const GivenLoad& load, const std::string& parameter,
                                      const std::string& function, const std::string& unit,
                                      const ActingTimes& times)
{
  const HistoryRange range = rangeOf(function, times);
  const double largest = range.largest, ever = largestEver(function, times.end);
  const std::string where = load.where + " > " + parameter,
                    upTo = "Time > Final Time = " + readableTime(times.end);
  if (largest == 0.0)
    return {where + " is zero up to " + upTo + ", so this " + load.noun + " does nothing" +
            (ever > 0.0 ? "; it reaches " + formatShort(ever) + " " + unit + " later: times are in seconds"
                        : "")};
  if (largest >= nextToNothing * ever)
    return betweenTimes({where, load.noun}, "it", range.acting, largest, " " + unit, times);
  return {where + ": up to " + upTo + " it is " + formatShort(largest) + " " + unit + " at most, " +
          formatShort(largest / ever) + " of the " + formatShort(ever) + " " + unit +
          " that it reaches later, so this " + load.noun + " does next to nothing; times are in seconds"};
}

std::vector<std::string> idleSupportMessages(const GivenLoad& support, const std::string& history,
                                             const ActingTimes& times)
{
  const HistoryRange range = rangeOf(history, times);
  return betweenTimes({support.where + " > History", support.noun}, "the integral of its factor",
                      range.actingIntegral, range.integral, " s", times);
}

} // namespace Rhegma
