#pragma once
/// Times a scene with cells that refine, next to the same scene without what makes it cheap.

#include <nlohmann/json.hpp>

#include <string>

namespace Rhegma::benchmarks
{

/// How much to measure.
struct AdaptiveEffort
{
  int rounds = 5;         ///< batches of each run, of which the best counts
  int finer = 2;          ///< uniform runs: with cells of 1/2, 1/4, ... of the scene's
  int levels = 0;         ///< if not 0, instead of uniform runs: up to how many levels substeps are timed
  double frontCells = 0;  ///< if not 0: replaces Adaptivity > Front Cells of the scene
  double interval = 2e-5; ///< simulated time of a batch [s]
};

/// Runs the scene as it is, and without Adaptivity and Sub-Cycling with smaller and smaller cells, by turns.
/// A batch takes as many samples of the history as the scene asks for in its time. Kokkos must be running.
/// Throws std::runtime_error where the scene's file can't be read, std::invalid_argument where nothing is
/// refined.
/// \return {threads, runs} with the best round of each run
nlohmann::json measureAdaptive(const std::string& sceneFile, const AdaptiveEffort& effort);

/// Runs the scene with Adaptivity > Maximum Level = 1, 2, ... `levels`, each with substeps in all its
/// small cells and with substeps everywhere (no Sub-Cycling), by turns and as above. \return {threads,
/// levels} with the best round of both at each level
nlohmann::json measureSmallSteps(const std::string& sceneFile, const AdaptiveEffort& effort);

} // namespace Rhegma::benchmarks
