#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "plausibility/Judges.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma
{

namespace
{

/// Who limits the steps knows what he does.
template <int D>
void judgeSteps(const JudgedScene<D>& judged, double end, Messages& messages)
{
  constexpr double most = 1e8; // years of computing for a million particles
  const double steps = end / judged.step;
  if (steps < 1.0)
    messages.push_back("Time > Final Time is " + readableTime(end) + ", " + formatShort(steps) +
                       " of the first stable step of " + readableTime(judged.step) +
                       ", so nothing happens; times are in seconds");
  else if (steps > most && judged.state.clock.maximumSteps > most)
    messages.push_back("Time > Final Time is " + readableTime(end) + ", which takes about " +
                       formatShort(steps) + " steps of " + readableTime(judged.step) +
                       "; write a shorter time or larger cells, and check units (m, s, Pa, kg/m3)");
}

/// Waves must cross a good part of some body, or its supports and loads do not learn of each other.
template <int D>
void judgeWaves(const JudgedScene<D>& judged, double end, Messages& messages)
{
  constexpr double part = 1.0 / 3.0; // half-spaces hit at one side use 0.5 and more
  const BodyMeasure<D>* best = nullptr;
  for (const BodyMeasure<D>& body : judged.bodies)
    if (body.size > 0.0 && (best == nullptr || body.speed / body.size > best->speed / best->size))
      best = &body;
  if (best == nullptr || end * best->speed >= part * best->size)
    return;
  messages.push_back(
      "Bodies > " + best->name + ": in Time > Final Time = " + readableTime(end) + " waves of " +
      formatShort(best->speed) + " m/s travel " + readableLength(end * best->speed) + ", and the body is " +
      readableLength(best->longest) + " long (" + formatShort(best->size / judged.state.mesh.grid.spacing) +
      " cells of " + readableLength(judged.state.mesh.grid.spacing) +
      "); most of it stays at rest: are lengths in metres, and the time in seconds?");
}

/// A body so large that its weight strains it ten times more than all its loads: hardly meant where there is
/// no gravity.
template <int D>
void judgeWeight(const JudgedScene<D>& judged, Messages& messages)
{
  constexpr double g = 9.81, times = 10.0;
  double highest = 0.0;
  for (const LoadEstimate& load : judged.loads)
    highest = std::max(highest, load.highest);
  for (const BodyMeasure<D>& body : judged.bodies)
    if (const double weight = body.density * g * body.longest; highest > 0.0 && weight > times * highest)
      messages.push_back("Bodies > " + body.name + ": its own weight would stress it with " +
                         formatShort(weight) + " Pa, more than its loads do (" + formatShort(highest) +
                         " Pa at most, by an estimate that includes bending): are lengths in metres, and "
                         "loads in N and Pa? It is " +
                         readableLength(body.longest) + " long");
}

} // namespace

template <int D>
Messages judgeTimes(const JudgedScene<D>& judged)
{
  Messages messages;
  const double end = judged.scene.sublist("Time").template get<double>("Final Time");
  judgeSteps(judged, end, messages);
  if (!judged.state.method.mechanics)
    return messages;
  if (!judged.state.method.equilibrium())
    judgeWaves(judged, end, messages);
  if (judged.state.method.analysis != Analysis::LoadFactor) // it multiplies loads of any size
    judgeWeight(judged, messages);
  return messages;
}

template Messages judgeTimes(const JudgedScene<2>&);
template Messages judgeTimes(const JudgedScene<3>&);

} // namespace Rhegma
