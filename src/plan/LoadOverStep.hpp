#pragma once
/// What a function of time gives over a step.

#include "scene/TimeFunction.hpp"
#include "state/State.hpp"

#include <Teuchos_ParameterList.hpp>

namespace Rhegma
{

/// Values of a load's function of time over the current step.
struct LoadOverStep
{
  double acts = 0.0;  ///< that the forces of the step have
  double works = 0.0; ///< with which they do work over the displacement of the step
};

/// In dynamics the value in the middle of the step. In equilibrium the value at its end acts and the mean of
/// those at both ends does work, as force and displacement grow together; at the start of a run bodies have
/// no stress, so a load that is there from time 0 on grows from zero in the first step. Where the loads have
/// a factor it multiplies their values at the final time.
template <int D>
LoadOverStep loadOverStep(const State<D>& state, const TimeFunction& history)
{
  const Clock& clock = state.clock;
  const double middle = clock.time + 0.5 * clock.dt, end = clock.time + clock.dt;
  if (state.method.analysis == Analysis::Dynamic)
  {
    const double now = history(middle);
    return {now, now};
  }
  if (state.method.analysis == Analysis::QuasiStatic)
  {
    const double now = history(end), before = clock.time > 0.0 ? history(clock.time) : 0.0;
    return {now, 0.5 * (now + before)};
  }
  if (state.method.analysis == Analysis::LoadFactor)
  {
    const double whole = history(clock.finalTime);
    return {whole * clock.factor.end, 0.5 * whole * (clock.factor.begin + clock.factor.end)};
  }
  const double at = state.method.analysis == Analysis::Preload ? 0.0 : clock.finalTime;
  const double whole = history(at) / clock.finalTime;
  return {whole * end, whole * middle};
}

/// Largest step of an equilibrium analysis [s].
inline double largestLoadStep(const Teuchos::ParameterList& scene)
{
  const Teuchos::ParameterList& time = scene.sublist("Time");
  const int usual = time.get<std::string>("Analysis") == "Quasi-Static" ? 20 : 1;
  return time.get<double>("Final Time") /
         (time.isParameter("Load Steps") ? time.get<int>("Load Steps") : usual);
}

/// Mean over the step of a function of time that is a velocity, for steps of equilibrium; in a static
/// analysis the same fraction of its whole integral in every step, and where the loads have a factor the part
/// of it by which that changes. Before a run starts nothing has moved.
template <int D>
double meanOverStep(const State<D>& state, const TimeFunction& history)
{
  if (state.method.analysis == Analysis::Preload)
    return 0.0;
  const bool hasFactor = state.method.analysis == Analysis::LoadFactor;
  const bool isStatic = state.method.analysis == Analysis::Static || hasFactor;
  const double from = isStatic ? 0.0 : state.clock.time;
  const double length = isStatic ? state.clock.finalTime : state.clock.dt;
  const double mean = history.mean(from, from + length);
  if (!hasFactor)
    return mean;
  return (state.clock.factor.end - state.clock.factor.begin) * state.clock.finalTime / state.clock.dt * mean;
}

} // namespace Rhegma
