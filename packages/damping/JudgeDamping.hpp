#pragma once
/// Whether damping leaves any motion (docs/plausibility.md).

#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "plausibility/BodyMeasures.hpp"

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

/// Warns of a run that is to end at rest and hardly damps any motion. With mass damping r an oscillation
/// falls as exp(-r t / 2), with a viscosity as exp(-w^2 t (2 eta + zeta) / (2 M)); that of the longest wave
/// of the quickest body lasts shorter than slower ones, by viscosity.
template <int D>
void judgeSettling(const JudgedDamping& damping, const BodyMeasure<D>& quick, State<D>& state)
{
  constexpr double pi = 3.14159265358979, most = 0.1; // loads that rise slowly make an oscillation of less
  const double frequency = pi * quick.speed / quick.longest;
  const double retardation = (2.0 * damping.shear + damping.bulk) / quick.moduli.constrainedModulus;
  const double rate = damping.rate + frequency * frequency * retardation;
  const double left = std::exp(-0.5 * rate * damping.end);
  if (damping.settled >= most || left <= most)
    return;
  state.warnings.push_back(
      "Damping > Mass Rate is " + formatReal(damping.rate) + " 1/s: when damping ends, " +
      formatShort(100.0 * left) + " % of an oscillation is left (after " + readableTime(damping.end) +
      "), but Stop When Settled needs " + formatShort(100.0 * damping.settled) +
      " %, so the run ends before it has settled, and its results are not static; write at least " +
      formatShort(-2.0 * std::log(damping.settled) / damping.end) + " 1/s (the longest wave of " +
      quick.name + " is critically damped at " + formatShort(2.0 * frequency) +
      ") or a longer Time > Final Time");
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
  constexpr double pi = 3.14159265358979;
  const double rate = damping.rate, end = damping.end;
  const BodyMeasure<D>* quick = nullptr;
  const std::vector<BodyMeasure<D>> bodies = measureBodies(state);
  for (const BodyMeasure<D>& body : bodies)
    if (quick == nullptr || body.longest / body.speed < quick->longest / quick->speed)
      quick = &body;
  if (quick == nullptr)
    return;
  const double frequency = pi * quick->speed / quick->longest, creep = rate / (frequency * frequency);
  if (creep > end)
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

} // namespace Rhegma::damping
