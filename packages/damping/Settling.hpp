#pragma once
/// Whether a run has settled.

#include "state/State.hpp"

#include <deque>

namespace Rhegma
{
class Archive;
}

namespace Rhegma::damping
{

/// Checks the last samples of a history.
class Settling
{
public:
  /// \param ratio  kinetic over strain energy at rest \param drift  relative change allowed \param samples at
  /// least 2
  Settling(double ratio, double drift, int samples) : ratio_(ratio), drift_(drift), samples_(samples) {}

  /// Adds a sample. \return true when kinetic over strain energy stayed below the ratio over the last
  /// samples, and every energy release rate that is a number (the strain energy where a row has none) within
  /// the drift of its latest value
  bool sample(double kinetic, double strain, const HistoryRow& row);

  /// How far what it watches may still move from its latest value, by the decay of its oscillation, as a
  /// fraction of that value: the largest of all that it watches. Not a number before there are enough
  /// samples.
  double mayStillChange() const;

  /// Saves or loads the last samples.
  void serialize(Archive& archive);

private:
  struct Sample
  {
    double ratio;
    std::vector<double> watched;
  };
  double ratio_, drift_;
  std::size_t samples_;
  std::deque<Sample> last_;
  std::deque<std::vector<double>>
      watched_; ///< what the last samples watched, as long as the list is the same
};

} // namespace Rhegma::damping
