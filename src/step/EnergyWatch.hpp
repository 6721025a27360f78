#pragma once
/// Detects a run that creates or loses energy.

#include "archive/Archive.hpp"
#include "base/Numbers.hpp"
#include "base/UnstableStep.hpp"
#include "state/EnergyBalance.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace Rhegma
{

/// What the energy balance of an analysis of equilibrium depends on, in addition to energies.
struct GrowthInEquilibrium
{
  bool grown = false;     ///< whether cracks have grown
  bool factor = false;    ///< whether loads are such that fronts advance at their toughness
  bool ended = false;     ///< whether a whole front has reached a surface or another crack
  bool nonlinear = false; ///< whether bodies flow plastically or strains are large
  bool heated = false;    ///< whether bodies got or gave heat
};

/// Checks the energy balance from sample to sample. An unstable step multiplies the energy of a few
/// particles; a body can burst long before a number overflows, but its energy reveals the instability.
class EnergyWatch
{
public:
  /// To be called with every sample of a run.
  /// \param ended whether a whole front has reached a surface or another crack: what bodies release as they
  /// come apart there is no release of growth
  void sample(const EnergyBalance& energy, bool ended = false)
  {
    supply(energy, std::fabs(energy.heat) + energy.roundOff, energy.heat);
    watch(energy, ended);
  }

  /// The same in equilibrium. Heat is not counted as supplied, as some millionths of it become mechanical
  /// energy; where there is heat, what bodies store and dissipate mechanically is counted.
  /// \param ofPath what the work of thermal strain may miss if the temperatures of this sample came in one
  /// load step (errorOfThermalPath) [J]
  void sampleOfEquilibrium(const EnergyBalance& energy, bool ended, double ofPath)
  {
    supply(energy, energy.roundOff, 0.0);
    heat_ = std::max(heat_, std::fabs(energy.heat));
    if (energy.heat != 0.0)
    {
      // The cube root is proportional to temperatures, of which those of the load step count.
      const double root = std::cbrt(ofPath), change = std::fabs(root - pathRoot_);
      pathRoot_ = root;
      pathError_ += change * change * change;
      const double has = energy.strain + energy.plastic + energy.fracture;
      exchanged_ = std::max(exchanged_, has + (pathError_ + energy.roundOff) / noticeable);
      supplied_ = std::max(supplied_, has);
    }
    watch(energy, ended);
  }

  /// Whether the run, up to the last sample, has created no more energy than it was given: a state worth
  /// storing. In equilibrium heat counts here, because a balance that is open by the work of thermal strain
  /// does not make a state wrong.
  bool sound() const { return std::isfinite(residual_) && residual_ <= exchanged_ + heat_; }

  /// What cracks had left open in the balance up to where a front reaches a surface, less what was open
  /// before they grew [J]: in equilibrium, where the load steps before may leave more than the growth.
  double residualOfGrowth() const { return ofGrowth_ - beforeGrowth_; }
  /// The energy of new faces up to the same sample [J].
  double fractureOfGrowth() const { return fracture_; }

  void serialize(Archive& archive)
  {
    archive("exchanged", exchanged_);
    archive("supplied", supplied_);
    archive("residual", residual_);
    archive("largest", largest_);
    archive("now", now_);
    archive("bursts", bursts_);
    archive("fracture", fracture_);
    archive("before_growth", beforeGrowth_);
    archive("of_growth", ofGrowth_);
    archive("heat", heat_);
    archive("path_error", pathError_);
    archive("path_root", pathRoot_);
  }

  /// \param subcycledLevels of the state
  /// \return why the run must stop; empty if it need not
  std::string failure(int subcycledLevels = 0) const
  {
    if (!std::isfinite(residual_))
      return "an energy is not finite" + advice(subcycledLevels);
    if (bursts_ < burstsInARow)
      return {};
    return "the energy of the bodies is " + readableEnergy(now_) + ", but at most " +
           readableEnergy(supplied_) + " was supplied" + advice(subcycledLevels);
  }

  /// \param losesByDesign whether the scene uses a scheme that dissipates energy without recording it
  /// \param steps         number of steps
  /// \param subcycledLevels of the state
  /// \return warning on the energy balance; empty if it closes
  std::string warning(bool losesByDesign, long steps, int subcycledLevels = 0) const
  {
    if (steps < fewSteps)
      return {};
    if (largest_ > noticeable * exchanged_)
      return "energy.residual: the run gained " + percent(largest_) +
             " % more energy than was supplied to the bodies" + advice(subcycledLevels);
    if (!losesByDesign && -residual_ > noticeable * exchanged_)
      return "energy.residual: the run lost " + percent(-residual_) +
             " % of the energy supplied to the bodies; use smaller cells";
    return {};
  }

  /// The most energy that bodies had been given at a sample: at the start, by work, gas and heat [J].
  double supplied() const { return supplied_; }

  /// The same for an analysis of equilibrium, of any number of steps: their work is taken as if forces rose
  /// in proportion to displacements. Where cracks have grown, what their faces took is compared with what was
  /// released, up to where a front reaches a surface. With a load factor both are the same; under given loads
  /// more may be released, but not less.
  std::string warningInEquilibrium(const GrowthInEquilibrium& growth) const
  {
    const double released = fracture_ - (ofGrowth_ - beforeGrowth_);
    const double apart = growth.factor ? std::fabs(released - fracture_) : fracture_ - released;
    const bool differs = growth.grown && apart > noticeable * fracture_ + std::fabs(beforeGrowth_);
    // Less than nothing is not released by a wrong G.
    if (differs && released >= 0.0 && !growth.nonlinear)
      return wrongRelease(released);
    if (!differs && !(std::fabs(residual_) > noticeable * exchanged_))
      return {};
    return "energy.residual: the energy balance of this analysis of equilibrium is open by " +
           readableEnergy(residual_) + ", " + percent(std::fabs(residual_)) +
           " % of the energy supplied to the bodies" +
           (differs ? " (" + readableEnergy(fracture_ - released) + " since cracks grew, whose faces took " +
                          readableEnergy(fracture_) + ")"
                    : std::string()) +
           ": " + reason(growth, differs && released < 0.0);
  }

private:
  /// Counts what was given. \param more its size in addition to mechanical energies \param heat of it [J]
  void supply(const EnergyBalance& energy, double more, double heat)
  {
    exchanged_ = std::max(exchanged_, std::fabs(energy.start) + std::fabs(energy.externalWork) +
                                          std::fabs(energy.combustion) + more);
    supplied_ = std::max(supplied_, energy.start + energy.externalWork + energy.combustion + heat);
  }

  void watch(const EnergyBalance& energy, bool ended)
  {
    residual_ = energy.residual();
    largest_ = std::max(largest_, residual_);
    bursts_ = residual_ > burst * (exchanged_ + heat_) ? bursts_ + 1 : 0;
    now_ = energy.kinetic + energy.strain;
    if (ended)
      return;
    fracture_ = energy.fracture;
    ofGrowth_ = residual_;
    if (!(fracture_ > 0.0))
      beforeGrowth_ = residual_;
  }

  static constexpr double burst = 10.0;     ///< times the energy that was given: an unstable run
  static constexpr int burstsInARow = 3;    ///< because the energy balance of the very first steps is rough
  static constexpr double noticeable = 0.1; ///< fraction of the energy that is reported
  static constexpr long fewSteps = 50; ///< velocities lag by half a step, which dominates in shorter runs

  static std::string advice(int subcycledLevels)
  {
    return " (" + unstableStep(subcycledLevels) +
           ", smaller cells, a lower load rate or another Cracks > Formulation)";
  }

  std::string wrongRelease(double released) const
  {
    return "energy.residual: new crack faces took " + readableEnergy(fracture_) +
           " (toughness times new area), but bodies and loads released " + readableEnergy(released) +
           " as cracks grew: G at which they grew is not the energy release rate, so neither the load nor "
           "the length of the cracks is right; see whether the domain integral for G (Propagation > Release "
           "Contour) "
           "contains another material, a load or a support, and use smaller increments (Propagation > "
           "Increment) and smaller cells (Domain > Cell Size)";
  }

  /// Why the balance of an equilibrium is open. \param negative whether growth seems to have released less
  /// than nothing
  std::string reason(const GrowthInEquilibrium& growth, bool negative) const
  {
    if (growth.ended && ofGrowth_ - residual_ > 0.5 * std::fabs(residual_))
      return "a front has reached a surface or another crack; what bodies release where they come apart is "
             "not dissipated by the crack, and would become motion; results up to there do not depend on it";
    if (growth.factor)
      return "the first load step leads to the load at which cracks start, and each other one is an "
             "increment; in each of them forces are taken to rise in proportion to displacements, which does "
             "not hold for plastic flow or large strain; use smaller increments (Propagation > Increment) "
             "or, if the residual is that of the first load step, Propagation > Load Control = Functions of "
             "Time with more Time > Load Steps";
    if (growth.grown && !growth.nonlinear && !negative)
      return "where G rises above the toughness in a load step, what is released above it is not "
             "dissipated by the crack, and would become motion; if growth is stable (propagation > "
             "unstable_from > time in summary.json is null), more Time > Load Steps reduce it";
    return std::string(
               "in a load step forces are taken to rise in proportion to displacements, which does not "
               "hold for plastic flow or large strain; use ") +
           (growth.heated ? "temperatures that change over several load steps (Time > Analysis = "
                            "Quasi-Static, with History of the boundaries that prescribe them), because the "
                            "first load step has all of those that are constant"
                          : "more Time > Load Steps");
  }

  /// Of the energy supplied; of what was exchanged, where the bodies only gave energy.
  std::string percent(double energy) const
  {
    return formatReal(std::round(1e3 * energy / (supplied_ > 0.0 ? supplied_ : exchanged_)) / 10.0);
  }

  double exchanged_ = 0.0; ///< most of the sum of what was given and what was taken back [J]
  double supplied_ = 0.0;  ///< most that the bodies had been given [J]
  double residual_ = 0.0, largest_ = 0.0, now_ = 0.0;
  double fracture_ = 0.0; ///< dissipated by new faces, up to where a front reaches a surface
  double beforeGrowth_ = 0.0, ofGrowth_ = 0.0; ///< residual before cracks grew, and with `fracture_`
  double heat_ = 0.0;                          ///< largest that bodies had got or given in equilibrium [J]
  double pathError_ = 0.0;                     ///< what the work of thermal strain may have missed so far [J]
  double pathRoot_ = 0.0; ///< cube root of what it would have missed in one load step [J^(1/3)]
  int bursts_ = 0;
};

} // namespace Rhegma
