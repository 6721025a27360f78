#pragma once
/// Whether damping leaves any motion (docs/reference/warnings-of-cracks-and-runs.md).

#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "damping/SlowMotion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
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

/// The body that is judged, and its slowest motion.
template <int D>
struct JudgedBody
{
  BodyMeasure<D> body;
  SlowMotion slowest;
};

/// Of the bodies with cracks (of all where none has one) the one whose slowest motion is fastest: if damping
/// does not bring that one to rest, it does so with none. \param holding by its boundaries \return nothing
/// without bodies. Call it before particles are divided among ranks.
template <int D>
std::optional<JudgedBody<D>> judgedBody(const State<D>& state, const Holding& holding)
{
  std::optional<JudgedBody<D>> quick;
  for (const BodyMeasure<D>& body : crackedBodies(state))
    if (const SlowMotion motion = slowestMotion(state, body, holding);
        body.mass > 0.0 && (!quick || motion.frequency > quick->slowest.frequency))
      quick = JudgedBody<D>{body, motion};
  return quick;
}

/// Warns of a run that is to end at rest and hardly damps any motion, or so strongly that bodies creep. With
/// mass damping r a motion falls as slowRate says, with a viscosity as exp(-w^2 t (2 eta + zeta) / (2 M)).
template <int D>
void judgeSettling(const JudgedDamping& damping, const JudgedBody<D>& judged,
                   std::vector<std::string>& warnings)
{
  // Loads that rise slowly make an oscillation of less than the motion, but leave more of it where it creeps;
  // of a hundredth G is 2 % off.
  constexpr double mostOscillation = 0.1, mostCreep = 0.01;
  const auto& [frequency, slowest, known] = judged.slowest;
  const double retardation = (2.0 * damping.shear + damping.bulk) / judged.body.moduli.constrainedModulus;
  const double rate = damping.rate + frequency * frequency * retardation;
  const double left = std::exp(-slowRate(rate, frequency) * damping.end);
  const bool creeps = rate > 2.0 * frequency;
  if (damping.settled >= mostOscillation || left <= (creeps ? mostCreep : mostOscillation))
    return;
  if (creeps)
  {
    warnings.push_back("Damping > Mass Rate is " + formatReal(damping.rate) + " 1/s, " +
                       formatShort(0.5 * rate / frequency) + " times the critical damping of " + slowest +
                       ", which creeps to equilibrium: when damping ends (after " +
                       readableTime(damping.end) + "), " + formatShort(100.0 * left) +
                       " % of the motion to equilibrium is left, so results are not static; write " +
                       (known ? "about " : "less than ") + formatShort(2.0 * frequency) + " 1/s");
    return;
  }
  warnings.push_back(
      "Damping > Mass Rate is " + formatReal(damping.rate) + " 1/s: when damping ends, " +
      formatShort(100.0 * left) + " % of an oscillation is left (after " + readableTime(damping.end) +
      "), but Stop When Settled needs " + formatShort(100.0 * damping.settled) +
      " %, so the run ends before it has settled, and its results are not static; write at least " +
      formatShort(-2.0 * std::log(damping.settled) / damping.end) + " 1/s" +
      (known ? " (" + slowest + " is critically damped at about " + formatShort(2.0 * frequency) + " 1/s)"
             : "") +
      " or a longer Time > Final Time");
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

/// Warns where a body can't come near rest before the end. With mass damping r its slowest motion, of
/// frequency w, creeps there in the time r / w^2, with a viscosity in (2 eta + zeta) / M.
template <int D>
void judgeDamping(const JudgedDamping& damping, const JudgedBody<D>& judged, State<D>& state)
{
  const double rate = damping.rate, end = damping.end, frequency = judged.slowest.frequency;
  const double creep = rate / (frequency * frequency);
  const bool creeps = creep > end;
  if (creeps)
    state.warnings.push_back("Damping > Mass Rate is " + formatReal(rate) + " 1/s: body " + judged.body.name +
                             ", " + readableLength(judged.body.longest) +
                             " long, creeps to equilibrium in about " + readableTime(creep) +
                             ", but is damped for " + readableTime(end) + ", so it hardly moves; " +
                             (judged.slowest.known ? judged.slowest.name + " is critically damped at about "
                                                   : "write less than ") +
                             formatShort(2.0 * frequency) + " 1/s");
  const double ofStep = rate * state.method.cfl * state.mesh.smallestSpacing() / judged.body.speed;
  if (ofStep > 1.0)
    state.warnings.push_back("Damping > Mass Rate is " + formatReal(rate) + " 1/s, " + formatShort(ofStep) +
                             " times 1 / (stable time step): a body loses its velocity in each step, and its "
                             "motion depends on the step; write less than " +
                             formatShort(0.1 * rate / ofStep) + " 1/s");
  if (!creeps)
    judgeSettling(damping, judged, state.warnings);
  const double retardation = (2.0 * damping.shear + damping.bulk) / judged.body.moduli.constrainedModulus;
  if (retardation > end / 3.0)
    state.warnings.push_back(
        "Damping > " +
        std::string(2.0 * damping.shear > damping.bulk ? "Shear Viscosity" : "Bulk Viscosity") +
        ": the retardation time, viscosity over stiffness, is " + readableTime(retardation) +
        ", but damping lasts only " + readableTime(end) +
        ", so the body hardly strains; viscosities are in Pa s");
}

/// What is known of a run that ended before it had settled.
struct Unsettled
{
  double rate = 0.0;              ///< of mass damping [1/s]
  std::optional<double> measured; ///< frequency by the decay of a motion that creeps [1/s]
  SlowMotion estimated;           ///< frequency 0: not known
  bool linear = false;            ///< equilibrium can be solved for
  /// How far its energy release rates may still move, as a fraction (Settling::mayStillChange); not a number
  /// where that is not known or its bodies still move.
  double change = std::numeric_limits<double>::quiet_NaN();
  double drift = 0.0; ///< Settled Drift
};

/// How near a run that has not settled is to rest: a change of a thousandth is below the errors of the cells.
inline std::string distanceFromRest(const Unsettled& run)
{
  constexpr double small = 1e-3;
  if (!std::isfinite(run.change))
    return ", so its results are not static; ";
  const std::string percent = formatShort(100.0 * run.change) + " %";
  return run.change > small
             ? ", so its results are not static: energy release rates (without a crack, the strain energy) "
               "may "
               "still change by up to " +
                   percent + "; "
             : " to within Settled Drift = " + formatReal(run.drift) +
                   "; its results are static all the same, but for changes of energy release rates (without "
                   "a crack, of the strain energy) by up to " +
                   percent + "; raise Settled Drift, or ";
}

/// Warns of it and says what to change.
inline std::string unsettledWarning(const Unsettled& run)
{
  std::string text =
      "the run ended before it had settled (Damping > Stop When Settled)" + distanceFromRest(run);
  const double critical = 2.0 * run.measured.value_or(run.estimated.frequency);
  const std::string about = "about " + formatShort(critical) + " 1/s";
  const std::string why = run.estimated.name + " is critically damped there";
  if (run.measured)
    text += "lower Damping > Mass Rate, " + formatReal(run.rate) + " 1/s, to " + about +
            ": the motion creeps to equilibrium, and by the decay of its kinetic energy it is critically "
            "damped there";
  else if (!(critical > 0.0))
    text += "raise Time > Final Time";
  else if (run.rate > critical)
    text += "raise Time > Final Time, or lower Damping > Mass Rate, " + formatReal(run.rate) + " 1/s, to " +
            about + " (" + why + ")";
  else if (run.rate > 0.0)
    text += "raise Time > Final Time, or Damping > Mass Rate, " + formatReal(run.rate) + " 1/s, to at most " +
            about + " (" + why + ")";
  else
    text += "raise Time > Final Time, or damp by a Mass Rate of " + about + " instead of a viscosity (" +
            why + ")";
  return text + (run.linear ? "; Time > Analysis = Static, without Damping, solves for the static "
                              "equilibrium directly"
                            : "");
}

} // namespace Rhegma::damping
