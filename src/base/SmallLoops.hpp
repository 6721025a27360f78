#pragma once
/// Loops over items that are few next to particles and nodes: points of loads, vertices of cracks, rows of a
/// mass matrix around a front.

#include "base/Types.hpp"

#include <type_traits>

namespace Rhegma
{

/// Items that one thread is through with sooner than others could be told to help.
constexpr int isSmallLoop = 256;

namespace detail
{
#ifdef KOKKOS_ENABLE_SERIAL
constexpr bool onHost = std::is_same_v<ExecSpace, Kokkos::DefaultHostExecutionSpace>;
using OneThread = std::conditional_t<onHost, Kokkos::Serial, ExecSpace>;
#else
using OneThread = ExecSpace;
#endif

/// Calls call(space) with the execution space that is through sooner with `count` items.
template <int limit, class Call>
void whereSooner([[maybe_unused]] int count, const Call& call)
{
  if constexpr (!std::is_same_v<OneThread, ExecSpace>)
    if (count <= limit)
    {
      call(OneThread());
      return;
    }
  call(ExecSpace());
}
} // namespace detail

/// Runs work(k) for k = begin .. end - 1, on a host by one thread where they are few. A device takes all at
/// once. \tparam limit how many are few; more where the work on one of them is little
template <int limit = isSmallLoop, class Work>
void parallelForSmall(const char* label, int begin, int end, const Work& work)
{
  detail::whereSooner<limit>(
      end - begin, [&](auto space)
      { Kokkos::parallel_for(label, Kokkos::RangePolicy<decltype(space)>(begin, end), work); });
}

template <class Work>
void parallelForSmall(const char* label, int count, const Work& work)
{
  parallelForSmall(label, 0, count, work);
}

/// The sums that work(k, sum ...) makes for k = begin .. end - 1, in the same way. \param sums where they go:
/// numbers, or an array as Kokkos takes it
template <class Work, class... Sums>
void parallelSumSmall(const char* label, int begin, int end, const Work& work, Sums&&... sums)
{
  detail::whereSooner<isSmallLoop>(
      end - begin, [&](auto space)
      { Kokkos::parallel_reduce(label, Kokkos::RangePolicy<decltype(space)>(begin, end), work, sums...); });
}

template <class Value, class Work>
Value parallelSumSmall(const char* label, int count, const Work& work)
{
  Value sum{};
  parallelSumSmall(label, 0, count, work, sum);
  return sum;
}

/// Counts and positions in the way of Kokkos::parallel_scan.
template <class Work>
void parallelScanSmall(const char* label, int begin, int end, const Work& work, int& count)
{
  detail::whereSooner<isSmallLoop>(
      end - begin, [&](auto space)
      { Kokkos::parallel_scan(label, Kokkos::RangePolicy<decltype(space)>(begin, end), work, count); });
}

} // namespace Rhegma
