#pragma once
/// Times the step of the program on the bodies, in this process and with its threads.

#include <nlohmann/json.hpp>

namespace Rhegma::benchmarks
{

/// How much to measure.
struct Effort
{
  int particles2 = 200000;
  int particles3 = 300000;
  int flow = 0;        ///< steps that bodies fly fast before they are timed
  int steps = 10;      ///< of each body in a round
  int rounds = 7;      ///< batches of each body, of which the best counts
  int triad = 1 << 25; ///< numbers in each array of the triad
};

/// Runs all bodies and the triad in turn, round by round, so that whatever else the machine does strikes all
/// of them alike. Kokkos must be running.
/// \return {threads, bandwidth_GBs, cases} with the best round of each; cases as throughput's JSON has them
nlohmann::json measure(const Effort& effort);

} // namespace Rhegma::benchmarks
