#pragma once
/// Whether a run has settled.

#include "state/State.hpp"

#include <deque>
#include <optional>
#include <utility>

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
  /// least 2 \param massDamping rate of mass damping [1/s]
  Settling(double ratio, double drift, int samples, double massDamping = 0.0)
      : ratio_(ratio), drift_(drift), samples_(samples), massDamping_(massDamping)
  {
  }

  /// Adds a sample. \param time of it [s] \return true when kinetic over strain energy stayed below the ratio
  /// over the last samples, and every energy release rate that is a number (the strain energy where a row has
  /// none) within the drift of its latest value, unless strong damping lets the body creep farther
  bool sample(double kinetic, double strain, const HistoryRow& row, double time = 0.0);

  /// Loads change up to a time: earlier samples count for nothing, and the run has not settled before its
  /// bodies can have answered. \param until [s]; 0: they are constant \param answer time that takes [s]
  void waitForLoads(double until, double answer)
  {
    loadsChangeUntil_ = until;
    answer_ = answer;
  }

  /// How far what it watches may still move from its latest value, by the decay of its oscillation, as a
  /// fraction of that value: the largest of all that it watches. Not a number before there are enough
  /// samples.
  double mayStillChange() const;

  /// Whether kinetic over strain energy is below the ratio in all of the last samples.
  bool isSlow() const;

  /// By how much energies may still change, as a fraction, where mass damping r far above critical lets a
  /// mode of the frequency w creep to rest in the time s = r / w^2, by which its kinetic energy T falls as
  /// exp(-2 t / s): what is left of its motion has the energy T r s, and energies change by 2 sqrt(T r s /
  /// U), U the strain energy. Zero where nothing creeps. Rates may pass a turning point meanwhile, at which
  /// they hardly change.
  double creep(double strain) const;

  /// Angular frequency of the motion that creeps to rest under mass damping r above critical: its kinetic
  /// energy falls as exp(-2 t / s), and w^2 = (r - 1 / s) / s, as both rates of decay of a mode have the
  /// product w^2 and the sum r [1/s]. Nothing where the energy does not fall steadily, or r s < 4 (at
  /// critical damping it is 2).
  std::optional<double> frequencyOfCreep() const;

  /// Saves or loads the last samples.
  void serialize(Archive& archive);

private:
  /// Time in which motion falls to 1 / e, by the last quarter of the samples [s]; nothing where its energy
  /// rises in between, or falls at several rates.
  std::optional<double> decayTime() const;

  void forget();

  struct Sample
  {
    double ratio;
    std::vector<double> watched;
  };
  double ratio_, drift_;
  std::size_t samples_;
  std::deque<Sample> last_;
  double massDamping_;
  double loadsChangeUntil_ = 0.0, answer_ = 0.0; ///< [s]
  std::deque<std::pair<double, double>> motion_; ///< times [s] and kinetic energies [J] of the last samples
  double creep_ = 0.0;                           ///< of the last sample
  std::deque<std::vector<double>>
      watched_; ///< what the last samples watched, as long as the list is the same
};

} // namespace Rhegma::damping
