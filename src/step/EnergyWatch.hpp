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

/// Checks the energy balance from sample to sample. An unstable step multiplies the energy of a few
/// particles; a body can burst long before a number overflows, but its energy reveals the instability.
class EnergyWatch
{
public:
  /// To be called with every sample of a run.
  void sample(const EnergyBalance& energy)
  {
    given_ = std::max(given_, std::fabs(energy.start) + std::fabs(energy.externalWork) +
                                  std::fabs(energy.combustion) + std::fabs(energy.heat) + energy.roundOff);
    residual_ = energy.residual();
    largest_ = std::max(largest_, residual_);
    bursts_ = residual_ > burst * given_ ? bursts_ + 1 : 0;
    now_ = energy.kinetic + energy.strain;
    fracture_ = energy.fracture;
    if (!(fracture_ > 0.0))
      beforeGrowth_ = residual_;
  }

  /// Whether the run, up to the last sample, has created no more energy than it was given: a state worth
  /// storing.
  bool sound() const { return std::isfinite(residual_) && residual_ <= given_; }

  void serialize(Archive& archive)
  {
    archive("given", given_);
    archive("residual", residual_);
    archive("largest", largest_);
    archive("now", now_);
    archive("bursts", bursts_);
    archive("fracture", fracture_);
    archive("before_growth", beforeGrowth_);
  }

  /// \param subcycledLevels of the state
  /// \return why the run must stop; empty if it need not
  std::string failure(int subcycledLevels = 0) const
  {
    if (!std::isfinite(residual_))
      return "an energy is not finite" + advice(subcycledLevels);
    if (bursts_ < burstsInARow)
      return {};
    return "the energy of the bodies is " + readableEnergy(now_) + ", but at most " + readableEnergy(given_) +
           " was supplied" + advice(subcycledLevels);
  }

  /// \param losesByDesign whether the scene uses a scheme that dissipates energy without recording it
  /// \param steps         number of steps
  /// \param subcycledLevels of the state
  /// \return warning on the energy balance; empty if it closes
  std::string warning(bool losesByDesign, long steps, int subcycledLevels = 0) const
  {
    if (steps < fewSteps)
      return {};
    if (largest_ > noticeable * given_)
      return "energy.residual: the run gained " + percent(largest_) +
             " % more energy than was supplied to the bodies" + advice(subcycledLevels);
    if (!losesByDesign && -residual_ > noticeable * given_)
      return "energy.residual: the run lost " + percent(-residual_) +
             " % of the energy supplied to the bodies; use smaller cells";
    return {};
  }

  /// The most energy that was supplied up to a sample [J].
  double given() const { return given_; }

  /// \param factor whether the loads were such that fronts advance at their toughness: what cracks take is
  /// then what is released. Under given loads more may be released, but not less
  /// \return warning where the energy of new faces in equilibrium is not the energy that was released; else
  /// empty
  std::string warningOfGrowth(bool factor) const
  {
    const double released = fracture_ - (residual_ - beforeGrowth_);
    const double apart = factor ? std::fabs(released - fracture_) : fracture_ - released;
    if (!(apart > noticeable * fracture_ + std::fabs(beforeGrowth_)))
      return {};
    return "energy.residual: new crack faces took " + readableEnergy(fracture_) +
           " (toughness times new area), but bodies and loads released " + readableEnergy(released) +
           " as cracks grew: G at which they grew is not the energy release rate, so neither the load nor "
           "the "
           "length of the cracks is right; see whether the contour of G (Propagation > Release Contour) "
           "contains another material, a load or a support, and use smaller cells (Domain > Cell Size)";
  }

  /// The same for an analysis of equilibrium, of any number of steps: their work is taken as if forces rose
  /// in proportion to displacements. \param grown whether cracks have grown under given loads
  std::string warningInEquilibrium(bool grown) const
  {
    if (!(std::fabs(residual_) > noticeable * given_))
      return {};
    return "energy.residual: the energy balance of this analysis of equilibrium is open by " +
           readableEnergy(residual_) + ", " + percent(std::fabs(residual_)) +
           " % of the energy supplied to the bodies: " +
           (grown ? "where G rises above the toughness in a load step, what is released above it is not "
                    "dissipated by the crack, and would become motion; if growth is stable (propagation > "
                    "unstable_from in summary.json is null), more Time > Load Steps reduce it"
                  : "in a load step forces are taken to rise in proportion to displacements, which does not "
                    "hold "
                    "for plastic flow or large strain; use more Time > Load Steps");
  }

private:
  static constexpr double burst = 10.0;     ///< times the energy that was given: an unstable run
  static constexpr int burstsInARow = 3;    ///< because the energy balance of the very first steps is rough
  static constexpr double noticeable = 0.1; ///< fraction of the energy that is reported
  static constexpr long fewSteps = 50; ///< velocities lag by half a step, which dominates in shorter runs

  static std::string advice(int subcycledLevels)
  {
    return " (" + unstableStep(subcycledLevels) +
           ", smaller cells, a lower load rate or another Cracks > Formulation)";
  }

  std::string percent(double energy) const { return formatReal(std::round(1e3 * energy / given_) / 10.0); }

  double given_ = 0.0; ///< most that was ever given [J]
  double residual_ = 0.0, largest_ = 0.0, now_ = 0.0;
  double fracture_ = 0.0, beforeGrowth_ = 0.0; ///< fracture energy now; residual before cracks grew
  int bursts_ = 0;
};

} // namespace Rhegma
