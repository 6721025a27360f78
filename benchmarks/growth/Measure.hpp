#pragma once
/// Times one scene whose cracks run next to the same scene with its cracks held.

#include <nlohmann/json.hpp>

#include <string>

namespace Rhegma::benchmarks
{

/// How much to measure.
struct GrowthEffort
{
  double cell = 0.0; ///< edge of the cells [m]; 0: the scene's
  int steps = 20;    ///< of the run with held cracks in a round; the others simulate the same time
  int rounds = 9;    ///< batches of each run, of which the best counts
  int warmUp = 40;   ///< steps of each after Propagation > Start Time, before the first batch
};

/// Runs the scene in turn, round by round, so that whatever else the machine does strikes all runs alike:
/// without the section Propagation; with a toughness that is never reached, so that what drives the fronts is
/// measured in every step and they stay; and as it is. All go on to Propagation > Start Time first, and take
/// samples as often as the scene's history does. Kokkos must be running. Throws std::runtime_error where the
/// scene's file can't be read and std::invalid_argument where it has no section Propagation or no front of it
/// advances in what is timed.
/// \return {particles, threads, increments, runs} with name, us (for what a step with held cracks simulates),
/// ratio to the first of that, ratio_of_steps, that of step to step, and ratio_of_processor, that of
/// processor time
nlohmann::json measureGrowth(const std::string& sceneFile, const GrowthEffort& effort);

} // namespace Rhegma::benchmarks
