#include "throughput/Triad.hpp"

namespace Rhegma::benchmarks
{

Triad::Triad(int length) : length_(length), a_("a", length), b_("b", length), c_("c", length)
{
  Kokkos::deep_copy(b_, 1.0);
  Kokkos::deep_copy(c_, 2.0);
}

double Triad::pass()
{
  double* const a = a_.data();
  const double* const b = b_.data();
  const double* const c = c_.data();
  const Kokkos::Timer timer;
  Kokkos::parallel_for(
      "triad", Kokkos::RangePolicy<Kokkos::DefaultExecutionSpace>(0, length_),
      KOKKOS_LAMBDA(const int i) { a[i] = b[i] + 3.0 * c[i]; });
  Kokkos::DefaultExecutionSpace().fence();
  return 1e-9 * 4.0 * sizeof(double) * length_ / timer.seconds();
}

} // namespace Rhegma::benchmarks
