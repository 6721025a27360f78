#pragma once
/// Notices a run that makes energy out of nothing, or loses it.

#include "archive/Archive.hpp"
#include "base/Numbers.hpp"
#include "base/UnstableStep.hpp"
#include "state/EnergyBalance.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace Rhegma
{

/// Follows the energy balance from sample to sample. An unstable step multiplies the energy of a few
/// particles, but a body can burst and come to an end long before a number overflows: its energy is what
/// gives it away.
class EnergyWatch
{
public:
  /// To be called with every sample of a run.
  void sample(const EnergyBalance& energy)
  {
    given_ = std::max(given_, energy.start + std::fabs(energy.externalWork) + std::fabs(energy.combustion) +
                                  std::fabs(energy.heat) + energy.roundOff);
    residual_ = energy.residual();
    largest_ = std::max(largest_, residual_);
    bursts_ = residual_ > burst * given_ ? bursts_ + 1 : 0;
    now_ = energy.kinetic + energy.strain;
  }

  /// Whether the run, up to the last sample, has made no more energy than it was given: a state worth
  /// keeping.
  bool sound() const { return std::isfinite(residual_) && residual_ <= given_; }

  void keep(Archive& archive)
  {
    archive("given", given_);
    archive("residual", residual_);
    archive("largest", largest_);
    archive("now", now_);
    archive("bursts", bursts_);
  }

  /// \param subcycledLevels of the state
  /// \return why the run can't go on; empty if it can
  std::string failure(int subcycledLevels = 0) const
  {
    if (!std::isfinite(residual_))
      return "an energy is not finite" + advice(subcycledLevels);
    if (bursts_ < burstsInARow)
      return {};
    return "the energy of the bodies is " + readableEnergy(now_) + ", but at most " + readableEnergy(given_) +
           " was supplied" + advice(subcycledLevels);
  }

  /// \param losesByDesign whether the scene asks for a scheme that takes energy which nobody energy balance
  /// \param steps         that were done
  /// \param subcycledLevels of the state
  /// \return what a user must know of the energy balance; empty if they balance
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

private:
  static constexpr double burst = 10.0;     ///< times the energy that was given: an unstable run
  static constexpr int burstsInARow = 3;    ///< for the energy balance of the very first steps are rough
  static constexpr double noticeable = 0.1; ///< share that a user is told of
  static constexpr long fewSteps = 50; ///< velocities are half a step behind; shorter runs show little else

  static std::string advice(int subcycledLevels)
  {
    return " (" + unstableStep(subcycledLevels) +
           ", smaller cells, a lower load rate or another Cracks > Formulation)";
  }

  std::string percent(double energy) const { return formatReal(std::round(1e3 * energy / given_) / 10.0); }

  double given_ = 0.0; ///< most that was ever given [J]
  double residual_ = 0.0, largest_ = 0.0, now_ = 0.0;
  int bursts_ = 0;
};

} // namespace Rhegma
