#pragma once
/// Loops over items that are few next to particles and nodes: points of loads, vertices of cracks, rows of a
/// mass matrix around a front.

#include "base/Types.hpp"

#include <type_traits>

namespace Rhegma
{

/// Number of items up to which one thread is faster than starting several.
constexpr int isSmallLoop = 256;

namespace detail
{
#ifdef KOKKOS_ENABLE_SERIAL
constexpr bool onHost = std::is_same_v<ExecSpace, Kokkos::DefaultHostExecutionSpace>;
using OneThread = std::conditional_t<onHost, Kokkos::Serial, ExecSpace>;
#else
using OneThread = ExecSpace;
#endif

/// Calls call(space) with the execution space that processes `count` items faster.
template <int limit, class Call>
void onFasterSpace([[maybe_unused]] int count, const Call& call)
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

/// Runs body(k) for k = begin .. end - 1, on a host by one thread where they are few. A device takes all at
/// once. \tparam limit how many are few; more where one of them costs little
template <int limit = isSmallLoop, class Body>
void parallelForSmall(const char* label, int begin, int end, const Body& body)
{
  detail::onFasterSpace<limit>(
      end - begin, [&](auto space)
      { Kokkos::parallel_for(label, Kokkos::RangePolicy<decltype(space)>(begin, end), body); });
}

template <class Body>
void parallelForSmall(const char* label, int count, const Body& body)
{
  parallelForSmall(label, 0, count, body);
}

/// Sums what body(k, sum ...) adds for k = begin .. end - 1, in the same way. \param sums results: numbers,
/// or an array as in Kokkos::parallel_reduce
template <class Body, class... Sums>
void parallelSumSmall(const char* label, int begin, int end, const Body& body, Sums&&... sums)
{
  detail::onFasterSpace<isSmallLoop>(
      end - begin, [&](auto space)
      { Kokkos::parallel_reduce(label, Kokkos::RangePolicy<decltype(space)>(begin, end), body, sums...); });
}

template <class Value, class Body>
Value parallelSumSmall(const char* label, int count, const Body& body)
{
  Value sum{};
  parallelSumSmall(label, 0, count, body, sum);
  return sum;
}

/// Counts and offsets, as Kokkos::parallel_scan.
template <class Body>
void parallelScanSmall(const char* label, int begin, int end, const Body& body, int& count)
{
  detail::onFasterSpace<isSmallLoop>(
      end - begin, [&](auto space)
      { Kokkos::parallel_scan(label, Kokkos::RangePolicy<decltype(space)>(begin, end), body, count); });
}

} // namespace Rhegma
