#pragma once
/// Times a scene on all ranks next to the same scene on one of them.

#include <nlohmann/json.hpp>

#include <string>

namespace Rhegma::benchmarks
{

/// Size of the measurement, and the assumed machine of many ranks.
struct RanksEffort
{
  int rounds = 5;          ///< batches of each run, of which the best counts
  int finer = 1;           ///< cells of 1/finer of the scene's
  double interval = 1e-5;  ///< simulated time of a batch [s]
  double latency = 2e-6;   ///< of a message [s]
  double bandwidth = 1e10; ///< between two ranks [bytes/s]
};

/// Runs the scene on the first rank alone, while the others sleep, and on all ranks, by turns. A batch takes
/// as many samples of the history as the scene asks for in its time. MPI and Kokkos must be running.
/// Collective. \return {ranks, runs, times_faster, messages, model}; messages: of the rank that sends the
/// most of them, a step; model: how long a step takes, and which fraction of it is work, where each of P
/// ranks has as much to do as the one run alone and as many neighbours as the ranks here
nlohmann::json measureRanks(const std::string& sceneFile, const RanksEffort& effort);

} // namespace Rhegma::benchmarks
