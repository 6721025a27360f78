#pragma once
/// When a front advanced, and when it advances next.

#include "propagation/Toughness.hpp"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace Rhegma
{
class Archive;
}

namespace Rhegma::propagation
{

/// The rule for the advance of fronts.
struct AdvanceRule
{
  Toughness toughness;
  double initiation = 0.0;  ///< energy release rate at which a front at rest initiates [J/m2]
  double arrest = 0.0;      ///< and below which one that has almost stopped arrests [J/m2]
  double startTime = 0.0;   ///< before which no front advances [s]
  double temperature = 0.0; ///< of the front [K]
};

/// Whether the start time of a rule is reached, up to rounding: load steps add up to it. [s]
inline bool hasStarted(double time, double startTime) { return time >= (1.0 - 1e-9) * startTime; }

/// What a front does in a step.
struct Advance
{
  int increments = 0;
  double toughness = 0.0; ///< mean of the increments' [J/m2]
};

/// What a front did between initiation and arrest.
struct CrackRun
{
  double initiation = 0.0;  ///< [s]
  double lastAdvance = 0.0; ///< time of its last increment [s]
  double length = 0.0;      ///< by which it grew [m]
};

/// The advances of a front in time. Its speed is a result: the front advances by da at the time at which
///
///     G(t) = Gc(da / (t - t_last)),
///
/// so that Gc is evaluated at the speed of this increment. With a mean over earlier increments, a crack once
/// stopped by a wave would never run again. The time is interpolated in the step, so that speeds are not
/// multiples of da / dt. No increment takes less than da / fastest.
class FrontHistory
{
public:
  /// Decides what the front does in the step that ended at `time`.
  /// \param release energy release rate now [J/m2] \param increment da [m] \param fastest speed [m/s]
  Advance advance(const AdvanceRule& rule, double time, double release, double increment, double fastest);

  /// Whether advance() would make an increment: nothing is recorded.
  bool wouldAdvance(const AdvanceRule& rule, double time, double release, double increment,
                    double fastest) const;

  /// Whether the energy release rate must be known at the end of a step. It need not where the last increment
  /// is so recent that none can follow in this step nor in the next; else if the last sample is older than
  /// `interval` [s], or if the front would advance by the straight line through the last two samples, which
  /// may be too low by 5 %.
  /// \param dt length of the step [s] \param increment, fastest as for advance()
  bool isDue(const AdvanceRule& rule, double time, double dt, double interval, double increment,
             double fastest) const;

  /// Records an advance in equilibrium, which has no speed. \param release energy release rate there [J/m2]
  void advanceInEquilibrium(double time, double release, double increment);

  /// Goes on as motion: increments in equilibrium have no speed and belong to no run. A front that has grown
  /// is in a run, which begins with its next increment.
  void startMotion() { starts_.assign(running_ ? 1 : 0, static_cast<int>(times_.size())); }

  /// Records a sample in which a front at rest does not initiate.
  void recordAtRest(const AdvanceRule& rule, double time, double release);

  /// Whether it is slower than a fiftieth of the speed `fastest` [m/s], so that it may be arrested.
  bool hasAlmostStopped(double time, double fastest) const;

  /// Mean energy release rate since the last increment [J/m2]; 0 where there is none.
  double meanSinceAdvance() const;

  /// Present speed: that of the last increment, or less when the next one is overdue [m/s].
  double speed(double time) const;

  /// Whether a front that initiates in the step that ended at `time` was held by AdvanceRule::startTime: it
  /// lies after the last sample, and G had reached the toughness before it, at that sample or on the straight
  /// line from there. To be asked before advance(), with its arguments.
  bool wasHeld(const AdvanceRule& rule, double time, double release) const;

  bool running() const { return running_; }
  long increments() const { return static_cast<long>(times_.size()); }
  double firstTime() const { return times_.empty() ? 0.0 : times_.front(); }
  double lastTime() const { return last_; }
  /// Largest energy release rate at the front as a fraction of the initiation toughness, at rest, from
  /// AdvanceRule::startTime on and before it first initiated.
  double closest() const { return closest_; }
  /// The same before AdvanceRule::startTime, of the samples that there were.
  double early() const { return early_; }

  /// The energy release rate and the toughness above it with which the front arrested last [J/m2]; zeros
  /// where it has not.
  std::pair<double, double> arrest() const { return {arrestRelease_, arrestToughness_}; }

  /// All its runs; the last may not be over.
  std::vector<CrackRun> runs() const;

  /// Mean speed over all its runs: the advance after the first increment of each, over the time from its
  /// initiation to its last increment [m/s]. Time at rest between runs does not count; 0 where no run has two
  /// increments.
  double meanSpeed() const;

  /// Start and end of the second half of its longest run [s]; none where that had fewer than four increments.
  std::pair<double, double> settled() const;
  /// Mean speed in that time [m/s].
  double settledSpeed() const;
  /// Mean energy release rate in that time [J/m2].
  double settledRelease() const;

  void serialize(Archive& archive);

private:
  std::pair<std::size_t, std::size_t> longestRun() const;
  std::pair<std::size_t, std::size_t> secondHalf() const;
  void recordRelease(double time, double release);
  void recordIncrement(double time, double increment);

  bool running_ = false;
  double closest_ = 0.0, early_ = 0.0;
  double last_ = 0.0;                             ///< time of the last increment [s]
  double lastSpeed_ = 0.0;                        ///< of the last increment [m/s]
  double increment_ = 0.0;                        ///< its length [m]
  double timeBefore_ = 0.0, releaseBefore_ = 0.0; ///< of the last sample [s, J/m2]
  double rate_ = 0.0; ///< between the last two samples; 0 if the front has advanced since [J/m2/s]
  double arrestRelease_ = 0.0, arrestToughness_ = 0.0; ///< of the last arrest [J/m2]
  double impulse_ = 0.0;                               ///< energy release rate over time, all of it [J s/m2]
  std::vector<double> times_, lengths_, impulses_;     ///< of each increment; impulses_ up to it
  std::vector<int> starts_;                            ///< increments with which its runs begin
};

} // namespace Rhegma::propagation
