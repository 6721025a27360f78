#pragma once
/// Times a scene with cells that refine, beside the same scene with small cells everywhere.

#include <nlohmann/json.hpp>

#include <string>

namespace Rhegma::benchmarks
{

/// How much to measure.
struct AdaptiveEffort
{
  int rounds = 5;         ///< batches of each run, of which the best counts
  int finer = 2;          ///< uniform runs: with cells of 1/2, 1/4, ... of the scene's
  double interval = 2e-5; ///< simulated time of a batch [s]
};

/// Runs the scene as it is, and without Adaptivity and Sub-Cycling with smaller and smaller cells, round by
/// round in turn, so that whatever else the machine does strikes all of them alike. A batch takes as many
/// samples of the history as the scene asks for in its time. Kokkos must be running. Throws
/// std::runtime_error where the scene's file can't be read, std::invalid_argument where nothing is refined.
/// \return {threads, runs} with the best round of each run
nlohmann::json measureAdaptive(const std::string& sceneFile, const AdaptiveEffort& effort);

} // namespace Rhegma::benchmarks
