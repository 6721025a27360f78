#pragma once
/// Runs that are timed next to each other in one process.

#include "Simulation.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace Rhegma::benchmarks
{

/// Some steps and the time they took.
struct Batch
{
  double seconds;
  double processorSeconds; ///< that the processors worked for this process, all threads together
  double simulated;        ///< time of the run that it covers [s]
  double steps;
  double particleSteps; ///< substeps of small cells counted too
};

/// A simulation and the times of its batches.
struct TimedRun
{
  std::string name;
  std::unique_ptr<Simulation> simulation;
  std::vector<Batch> batches;

  /// \param scene the scene; a body that settles is timed only while it moves
  /// \param comm ranks of the run; default: this one alone
  TimedRun(std::string which, const Teuchos::RCP<Teuchos::ParameterList>& scene,
           const Teuchos::RCP<const Teuchos::Comm<int>>& comm = Teuchos::null);

  /// Advances without timing.
  void advance(int steps);
  /// Advances with timing. \param simulated time of the run [s]
  void time(int steps);
  void time(double simulated);
  /// Advances by exactly this number of steps, with timing: a final time within the last step would split it.
  void timeWhole(int steps);

  /// The least of value(batch).
  template <class Value>
  double best(const Value& value) const
  {
    double least = std::numeric_limits<double>::max();
    for (const Batch& batch : batches)
      least = std::min(least, value(batch));
    return least;
  }

private:
  double lasting(int steps) const;
  void timeUntil(double end);
};

/// Times batches of all runs in turn, so that whatever else the machine does strikes all of them alike.
/// \param amount steps of a batch, or the time it simulates [s]
template <class Amount>
void timeByTurns(std::vector<TimedRun>& runs, int rounds, Amount amount)
{
  for (int round = 0; round < rounds; ++round)
    for (TimedRun& run : runs)
      run.time(amount);
}

} // namespace Rhegma::benchmarks
