#pragma once
/// One process for each number of threads: Kokkos can be started only once in a process.

#include <string>
#include <vector>

namespace Rhegma::benchmarks
{

/// Starts this program again with OMP_NUM_THREADS set and returns what it writes to its standard output.
/// Must be called before threads exist. Throws std::runtime_error when it fails.
std::string runAgain(const std::vector<std::string>& arguments, int threads);

} // namespace Rhegma::benchmarks
