#pragma once
/// The memory bandwidth of the machine, as the threads of this process see it.

#include <Kokkos_Core.hpp>

namespace Rhegma::benchmarks
{

/// a = b + s c over arrays much larger than any cache of this process. A store first reads the line that it
/// writes to (write-allocate), so each element moves four numbers.
/// Source: McCalpin, IEEE TCCA Newsletter (1995) 19, the kernel "triad".
class Triad
{
public:
  /// \param length numbers in each of the three arrays
  explicit Triad(int length);

  /// One pass. \return bytes moved a nanosecond, which is GB/s
  double pass();

private:
  int length_;
  Kokkos::View<double*, Kokkos::DefaultExecutionSpace> a_, b_, c_;
};

} // namespace Rhegma::benchmarks
