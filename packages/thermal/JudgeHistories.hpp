#pragma once
/// Whether the steps of a run see what heats its bodies (docs/reference/warnings-of-cracks-and-runs.md).

#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "base/ShortNumber.hpp"
#include "plausibility/HistoryRange.hpp"
#include "thermal/Conduction.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace Rhegma::thermal
{

/// The longest step of conduction of a run whose steps may be longer than what a history does [s]; 0 in
/// dynamics, whose steps are those of waves, and in steady states.
template <int D>
double longestStep(const Teuchos::ParameterList& scene, const Conduction<D>& conduction, double end,
                   const State<D>& state)
{
  if (!state.method.mechanics)
    return std::min({conduction.stepLimit(state), conduction.sourceLimit(state), end / 100.0});
  if (!state.method.equilibrium() || conduction.integrator.method == Method::Steady)
    return 0.0;
  const double whole = largestLoadStep(scene);
  return whole / conduction.substeps(state, whole);
}

/// Integral of the absolute value of a function over a run by values in the middle of equal steps [s].
inline double integralInSteps(const TimeFunction& function, double end, int steps)
{
  double sum = 0.0;
  for (int k = 0; k < steps; ++k)
    sum += std::fabs(function((k + 0.5) * end / steps));
  return sum * end / steps;
}

/// The message on a history that steps do not see: of an expression each takes the value in its middle. Empty
/// where they see 80 % of its integral and no more than 120 %, and of tables, whose mean acts.
/// \param end of the run \param step longest [s]
inline std::string messageOnShortPulse(const std::string& where, const std::string& history, double end,
                                       double step)
{
  constexpr double most = 4096.0, part = 0.2;
  const TimeFunction function = TimeFunction::parse(history);
  const double steps = std::ceil(end / step * (1.0 - 1e-12));
  if (!function.corners().empty() || !(steps >= 1.0 && 4.0 * steps <= most))
    return {};
  const double all = integralInSteps(function, end, static_cast<int>(most)),
               seen = integralInSteps(function, end, static_cast<int>(steps));
  if (!(std::fabs(seen - all) > part * all))
    return {};
  return where + " > History: it changes within time steps of " + readableTime(end / steps) + ", which see " +
         readableTime(seen) + " of its integral of " + readableTime(all) +
         "; write it as a table of time:value, whose mean over each step acts";
}

/// Warns of sources and heat fluxes whose history the steps do not see. \param scene its core and Thermal
template <int D>
void judgeShortPulses(const Teuchos::ParameterList& scene, const Conduction<D>& conduction, double end,
                      State<D>& state)
{
  const double step = longestStep(scene, conduction, end, state);
  if (!(step > 0.0))
    return;
  std::map<std::string, std::string> known; // many sources have the same history
  const auto judge = [&](const Teuchos::ParameterList& list, const std::string& where)
  {
    const std::string history = list.get<std::string>("History");
    const auto [at, isNew] = known.emplace(history, "");
    if (!isNew)
      return;
    at->second = messageOnShortPulse(where, history, end, step);
    if (!at->second.empty())
      state.warnings.push_back(at->second);
  };
  const Teuchos::ParameterList none;
  const Teuchos::ParameterList& thermal = scene.sublist("Thermal");
  const Teuchos::ParameterList& sources = thermal.isSublist("Sources") ? thermal.sublist("Sources") : none;
  for (const std::string& name : sublistNames(sources))
    judge(sources.sublist(name), "Thermal > Sources > " + name);
  const Teuchos::ParameterList& boundaries =
      scene.isSublist("Boundaries") ? scene.sublist("Boundaries") : none;
  for (const std::string& name : sublistNames(boundaries))
    if (boundaries.sublist(name).get<std::string>("Type") == "Heat Flux")
      judge(boundaries.sublist(name), "Boundaries > " + name);
}

/// Warns in equilibrium of temperatures that are farther from the initial one between load steps than at
/// their ends, where stress is computed. \param scene its core and Thermal
template <int D>
void judgeHeldInSteps(const Teuchos::ParameterList& scene, State<D>& state)
{
  constexpr double half = 0.5;
  const ActingTimes times = actingTimes(scene, state);
  if (!state.method.mechanics || times.steps == 0 || !scene.isSublist("Boundaries"))
    return;
  const double initial = scene.sublist("Thermal").get<double>("Initial Temperature");
  for (const std::string& name : sublistNames(scene.sublist("Boundaries")))
  {
    const Teuchos::ParameterList& list = scene.sublist("Boundaries").sublist(name);
    for (const char* value : {"Temperature", "Ambient Temperature"})
    {
      if (!list.isType<double>(value))
        continue;
      const TimeFunction history = TimeFunction::parse(list.get<std::string>("History"));
      const double size = list.get<double>(value);
      const HistoryRange range =
          rangeOf([&](double t) { return size * history(t) - initial; }, history.corners(), times);
      if (range.acting < half * range.largest)
        state.warnings.push_back("Boundaries > " + name + " > History: the temperature is up to " +
                                 formatShort(range.largest) +
                                 " K from Thermal > Initial Temperature between load steps, and at most " +
                                 formatShort(range.acting) +
                                 " K at the ends of load steps, where stress is computed: use more "
                                 "Time > Load Steps than " +
                                 std::to_string(times.steps));
    }
  }
}

} // namespace Rhegma::thermal
