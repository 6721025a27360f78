#include "plausibility/IdleLoads.hpp"

#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "plausibility/LoadEstimate.hpp"
#include "scene/TimeFunction.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma
{

namespace
{

/// Part of the full load below which a load does next to nothing, and below which it hardly acts.
constexpr double nextToNothing = 1e-3, hardlyAny = 0.2;

bool isZero(const Teuchos::ParameterList& list, const std::string& name)
{
  if (list.isType<double>(name))
    return list.get<double>(name) == 0.0;
  if (!list.isType<Teuchos::Array<double>>(name))
    return false;
  const auto& all = list.get<Teuchos::Array<double>>(name);
  return std::all_of(all.begin(), all.end(), [](double value) { return value == 0.0; });
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
                                      const std::vector<std::string>& values, double end)
{
  std::vector<std::string> messages;
  for (const std::string& value : values)
    if (isZero(list, value))
      messages.push_back(load.where + " > " + value + " is zero, so this " + load.noun + " does nothing");
  if (!list.isParameter("History"))
    return messages;
  const std::string history = list.get<std::string>("History");
  const double largest = rangeOf(history, end).largest, ever = largestEver(history, end);
  const std::string upTo = load.where + " > History: up to Time > Final Time = " + readableTime(end) +
                           " its factor is at most " + formatShort(largest);
  if (largest < nextToNothing)
    messages.push_back(upTo + ", so this " + load.noun + " does next to nothing; times are in seconds");
  else if (largest < hardlyAny * ever)
    messages.push_back(upTo + ", and it reaches " + formatShort(ever) +
                       " later: does the run end too early? Times are in seconds");
  return messages;
}

std::vector<std::string> idleMessages(const GivenLoad& load, const std::string& parameter,
                                      const std::string& function, const std::string& unit, double end)
{
  const double largest = rangeOf(function, end).largest, ever = largestEver(function, end);
  const std::string where = load.where + " > " + parameter, upTo = "Time > Final Time = " + readableTime(end);
  if (largest == 0.0)
    return {where + " is zero up to " + upTo + ", so this " + load.noun + " does nothing" +
            (ever > 0.0 ? "; it reaches " + formatShort(ever) + " " + unit + " later: times are in seconds"
                        : "")};
  if (largest >= nextToNothing * ever)
    return {};
  return {where + ": up to " + upTo + " it is " + formatShort(largest) + " " + unit + " at most, " +
          formatShort(largest / ever) + " of the " + formatShort(ever) + " " + unit +
          " that it reaches later, so this " + load.noun + " does next to nothing; times are in seconds"};
}

} // namespace Rhegma
