#pragma once
/// Time that a measurement may take.

#include "parallel/Ranks.hpp"

#include <algorithm>

namespace Rhegma::program
{

/// Processor time of this thread since its start [s]; on a device, where the host waits, that of the clock.
double processorSeconds();

/// Time of the clock since some moment [s].
double wallSeconds();

/// Time since it was made. A busy machine may take some times that of the processor by the clock.
class Budget
{
public:
  explicit Budget(const Ranks& ranks) : ranks_(ranks) {}
  /// \param seconds of processor time \return whether less is spent, and not much more by the clock.
  /// Collective
  bool less(double seconds) const
  {
    return ranks_.max(std::max(own(), 0.25 * (wallSeconds() - wall_))) < seconds;
  }
  /// Processor time of the rank that spent most [s]. Collective.
  double spent() const { return ranks_.max(own()); }
  /// Time by the clock over that of the processor, where this rank spent any [1].
  double busy() const { return own() > 0.0 ? std::max(1.0, (wallSeconds() - wall_) / own()) : 1.0; }

private:
  double own() const { return processorSeconds() - processor_; }

  const Ranks& ranks_;
  double wall_ = wallSeconds(), processor_ = processorSeconds();
};

} // namespace Rhegma::program
