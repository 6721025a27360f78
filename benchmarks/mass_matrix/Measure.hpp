#pragma once
/// Times the step of one scene with each mass matrix.

#include <nlohmann/json.hpp>

#include <string>

namespace Rhegma::benchmarks
{

/// How much to measure.
struct MassMatrixEffort
{
  int steps = 40;   ///< of each matrix in a round
  int rounds = 9;   ///< batches of each matrix, of which the best counts
  int warmUp = 100; ///< steps of each before the first batch, so that the body moves
};

/// Runs the scene with the matrices in turn, round by round, so that whatever else the machine does strikes
/// all of them alike. Samples are not taken. Kokkos must be running. Throws std::runtime_error where the
/// scene's file can't be read.
/// \return {particles, threads, matrices} with the best round of each matrix
nlohmann::json measureMassMatrices(const std::string& sceneFile, const MassMatrixEffort& effort);

} // namespace Rhegma::benchmarks
