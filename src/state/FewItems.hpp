#pragma once
/// Loops over items that are few beside particles and nodes: points of loads, vertices of cracks.

#include "state/Types.hpp"

#include <type_traits>

namespace Rhegma
{

/// Items that one thread is through with sooner than others could be told to help.
constexpr int fewItems = 256;

namespace detail
{
#ifdef KOKKOS_ENABLE_SERIAL
constexpr bool onHost = std::is_same_v<ExecSpace, Kokkos::DefaultHostExecutionSpace>;
using OneThread = std::conditional_t<onHost, Kokkos::Serial, ExecSpace>;
#else
using OneThread = ExecSpace;
#endif
} // namespace detail

/// Runs work(k) for k = 0 .. count - 1, on a host by one thread where they are few. A device takes all at
/// once.
template <class Work>
void forFew(const char* label, int count, const Work& work)
{
  if (count <= fewItems)
    Kokkos::parallel_for(label, Kokkos::RangePolicy<detail::OneThread>(0, count), work);
  else
    Kokkos::parallel_for(label, Kokkos::RangePolicy<ExecSpace>(0, count), work);
}

/// The sum that work(k, sum) makes, in the same way.
template <class Value, class Work>
Value sumFew(const char* label, int count, const Work& work)
{
  Value sum{};
  if (count <= fewItems)
    Kokkos::parallel_reduce(label, Kokkos::RangePolicy<detail::OneThread>(0, count), work, sum);
  else
    Kokkos::parallel_reduce(label, Kokkos::RangePolicy<ExecSpace>(0, count), work, sum);
  return sum;
}

} // namespace Rhegma
