#pragma once
/// Messages of this rank, counted in the calls of MPI.

namespace Rhegma::benchmarks
{

/// Since the last call of beginCount.
struct Messages
{
  double sent = 0.0;         ///< messages to single ranks
  double bytes = 0.0;        ///< in them
  double reductions = 0.0;   ///< sums and the like over all ranks
  double reducedBytes = 0.0; ///< in them
  double receivers = 0.0;    ///< ranks that got a message
};

void beginCount();
Messages counted();

} // namespace Rhegma::benchmarks
