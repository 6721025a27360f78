#pragma once
/// Times one scene with heat next to the same without, or heat alone by each method of conduction.

#include <nlohmann/json.hpp>

#include <string>

namespace Rhegma::benchmarks
{

/// How much to measure.
struct HeatEffort
{
  double cell = 0.0; ///< edge of the cells [m]; 0: the scene's
  int steps = 40;    ///< of each run in a round; with heat alone those of the explicit one
  int rounds = 9;    ///< batches of each run, of which the best counts
  int warmUp = 40;   ///< steps of each before the first batch
};

/// Runs the scene in turn, round by round, so that whatever else the machine does strikes all runs alike:
/// where bodies move with and without its heat, a step next to a step; with heat alone explicitly, by super
/// time stepping and implicitly, time of the run next to time of the run. Kokkos must be running. Throws
/// std::runtime_error where the scene's file can't be read and std::invalid_argument where it has no heat.
/// \return {particles, threads, runs} with name, us (of a step, or of what an explicit step simulates) and
/// ratio to the first
nlohmann::json measureHeat(const std::string& sceneFile, const HeatEffort& effort);

} // namespace Rhegma::benchmarks
