#pragma once
/// Times one scene whose cracks burn next to the same scene without.

#include <nlohmann/json.hpp>

#include <string>

namespace Rhegma::benchmarks
{

/// How much to measure.
struct CombustionEffort
{
  int steps = 40;  ///< of each run in a round
  int rounds = 9;  ///< batches of each run, of which the best counts
  int warmUp = 40; ///< steps of each before the first batch
};

/// Runs the scene in turn, round by round, so that whatever else the machine does strikes all runs alike:
/// without combustion, so that nothing acts on its cracks; so too, but with bodies that move, as a body whose
/// particles lie where they were seeded touches fewer nodes than any that has moved; with a constant pressure
/// in the cracks, so that they are open and move without gas; with gas of one pressure in them; and, in 2D,
/// with gas that flows along them. Cracks stay as long as they are. Kokkos must be running. Throws
/// std::runtime_error where the scene's file can't be read and std::invalid_argument where nothing burns in
/// it. \return {particles, threads, runs} with name, us (for what a step without combustion simulates), ratio
/// to the first of that, ratio_of_steps, that of step to step, and ratio_of_processor, that of processor time
/// for the same simulated time
nlohmann::json measureCombustion(const std::string& sceneFile, const CombustionEffort& effort);

} // namespace Rhegma::benchmarks
