#pragma once
/// Whether damping leaves any motion (docs/plausibility.md).

#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "plausibility/CrackExtent.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace Rhegma::damping
{

/// What the section Damping says.
struct JudgedDamping
{
  double rate;        ///< of mass damping [1/s]
  double shear, bulk; ///< viscosities [Pa s]
  double end;         ///< of damping or run [s]
  double settled;     ///< part of an oscillation that is left when the run is to end at rest; 1: never
};

/// Rate at which a mode of the angular frequency w falls to rest with mass damping r [1/s]: r / 2 up to
/// critical damping r = 2 w; above it the slower of two rates, which falls towards w^2 / r.
inline double slowRate(double damping, double frequency)
{
  const double half = 0.5 * damping, under = half * half - frequency * frequency;
  return under > 0.0 ? frequency * frequency / (half + std::sqrt(under)) : half;
}

/// Body whose longest wave has the shortest period; nullptr without bodies.
template <int D>
const BodyMeasure<D>* quickest(const std::vector<BodyMeasure<D>>& bodies)
{
  const BodyMeasure<D>* quick = nullptr;
  for (const BodyMeasure<D>& body : bodies)
    if (quick == nullptr || body.longest / body.speed < quick->longest / quick->speed)
      quick = &body;
  return quick;
}

/// Angular frequency of the longest wave of a body, pi c / L [1/s].
template <int D>
double lowestFrequency(const BodyMeasure<D>& body)
{
  constexpr double pi = 3.14159265358979;
  return pi * body.speed / body.longest;
}

/// The slowest motion of a body that damping must bring to rest.
struct SlowMotion
{
  double frequency; ///< angular [1/s]
  std::string name; ///< for a message
};

/// The longest wave, or, where a crack leaves slender arms of half of the body's thickness h, their
/// bending: 3.52 / sqrt(12) c h / a^2 of a cantilever of length a (Timoshenko, Vibration Problems in
/// Engineering, 1928).
template <int D>
SlowMotion slowestMotion(const State<D>& state, const BodyMeasure<D>& body)
{
  constexpr double slender = 3.0; // a cantilever shorter than that shears
  const std::vector<BodyMeasure<D>> cracked = crackedBodies(state);
  const bool has = std::any_of(cracked.begin(), cracked.end(),
                               [&](const BodyMeasure<D>& one) { return one.name == body.name; });
  const double wave = lowestFrequency(body), h = 0.5 * body.shortest, a = has ? longestCrack(state) : 0.0;
  const double bending = a > slender * h ? 3.52 / std::sqrt(12.0) * body.speed * h / (a * a) : wave;
  if (bending >= wave)
    return {wave, "the longest wave of " + body.name};
  return {bending, "the bending of arms of " + body.name + ", " + readableLength(h) + " thick and " +
                       readableLength(a) + " long, next to its crack"};
}

/// Warns of a run that is to end at rest and hardly damps any motion, or so strongly that bodies creep. With
/// mass damping r an oscillation falls as slowRate says, with a viscosity as exp(-w^2 t (2 eta + zeta) /
/// (2 M)); that of the longest wave of the quickest body lasts shorter than slower ones.
template <int D>
void judgeSettling(const JudgedDamping& damping, const BodyMeasure<D>& quick, State<D>& state)
{
  constexpr double most = 0.1; // loads that rise slowly make an oscillation of less
  const auto [frequency, slowest] = slowestMotion(state, quick);
  const double retardation = (2.0 * damping.shear + damping.bulk) / quick.moduli.constrainedModulus;
  const double rate = damping.rate + frequency * frequency * retardation;
  const double left = std::exp(-slowRate(rate, frequency) * damping.end);
  if (damping.settled >= most || left <= most)
    return;
  if (rate > 2.0 * frequency)
  {
    state.warnings.push_back(
        "Damping > Mass Rate is " + formatReal(damping.rate) + " 1/s, " +
        formatShort(0.5 * rate / frequency) + " times the critical damping of " + slowest +
        ", which creeps to equilibrium: when damping ends (after " + readableTime(damping.end) + "), " +
        formatShort(100.0 * left) +
        " % of the motion to equilibrium is left, so results are not static; write about " +
        formatShort(2.0 * frequency) + " 1/s");
    return;
  }
  state.warnings.push_back(
      "Damping > Mass Rate is " + formatReal(damping.rate) + " 1/s: when damping ends, " +
      formatShort(100.0 * left) + " % of an oscillation is left (after " + readableTime(damping.end) +
      "), but Stop When Settled needs " + formatShort(100.0 * damping.settled) +
      " %, so the run ends before it has settled, and its results are not static; write at least " +
      formatShort(-2.0 * std::log(damping.settled) / damping.end) + " 1/s (" + slowest +
      " is critically damped at " + formatShort(2.0 * frequency) + ") or a longer Time > Final Time");
}

/// Warns of a run that is to end at rest and takes too few samples to see that. \param interval between two
/// samples, end of the run [s] \param samples that are compared
inline void judgeSamples(double interval, double end, int samples, std::vector<std::string>& warnings)
{
  if (end >= (samples - 1 + 1e-6) * interval)
    return;
  warnings.push_back("Output > History Interval is " + readableTime(interval) + ", and up to Time > Final " +
                     "Time = " + readableTime(end) + " there are " +
                     std::to_string(static_cast<int>(end / interval)) +
                     " samples: Damping > Stop When Settled compares the last " + std::to_string(samples) +
                     ", so the run does not end at rest; write at most " +
                     readableTime(end / (2.0 * samples)) + ", or a later end");
}

/// Warns where a body can't come near rest before the end. With mass damping r its longest wave, of frequency
/// w = pi c / L, creeps there in the time r / w^2, with a viscosity in (2 eta + zeta) / M.
template <int D>
void judgeDamping(const JudgedDamping& damping, State<D>& state)
{
  const double rate = damping.rate, end = damping.end;
  const std::vector<BodyMeasure<D>> bodies = measureBodies(state);
  const BodyMeasure<D>* quick = quickest(bodies);
  if (quick == nullptr)
    return;
  const double frequency = lowestFrequency(*quick), creep = rate / (frequency * frequency);
  const bool creeps = creep > end;
  if (creeps)
    state.warnings.push_back("Damping > Mass Rate is " + formatReal(rate) + " 1/s: body " + quick->name +
                             ", " + readableLength(quick->longest) +
                             " long, creeps to equilibrium in about " + readableTime(creep) +
                             ", but is damped for " + readableTime(end) +
                             ", so it hardly moves; its longest wave is critically damped at " +
                             formatShort(2.0 * frequency) + " 1/s");
  const double ofStep = rate * state.method.cfl * state.mesh.smallestSpacing() / quick->speed;
  if (ofStep > 1.0)
    state.warnings.push_back("Damping > Mass Rate is " + formatReal(rate) + " 1/s, " + formatShort(ofStep) +
                             " times 1 / (stable time step): a body loses its velocity in each step, and its "
                             "motion depends on the step; write less than " +
                             formatShort(0.1 * rate / ofStep) + " 1/s");
  if (!creeps)
    judgeSettling(damping, *quick, state);
  const double retardation = (2.0 * damping.shear + damping.bulk) / quick->moduli.constrainedModulus;
  if (retardation > end / 3.0)
    state.warnings.push_back(
        "Damping > " +
        std::string(2.0 * damping.shear > damping.bulk ? "Shear Viscosity" : "Bulk Viscosity") +
        ": the retardation time, viscosity over stiffness, is " + readableTime(retardation) +
        ", but damping lasts only " + readableTime(end) +
        ", so the body hardly strains; viscosities are in Pa s");
}

/// The mass damping at which the slowest motion of the quickest body is critically damped, for a message.
template <int D>
std::string criticalAsText(const State<D>& state)
{
  const std::vector<BodyMeasure<D>> bodies = measureBodies(state);
  const BodyMeasure<D>* quick = quickest(bodies);
  if (quick == nullptr)
    return {};
  const auto [frequency, slowest] = slowestMotion(state, *quick);
  return " (" + slowest + " is critically damped at " + formatShort(2.0 * frequency) + " 1/s)";
}

} // namespace Rhegma::damping
