#pragma once
/// Loops over items that are few beside particles and nodes: points of loads, vertices of cracks, rows of a
/// mass matrix around a front.

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

/// Runs work(k) for k = begin .. end - 1, on a host by one thread where they are few. A device takes all at
/// once. \tparam limit how many are few; more where the work on one of them is little
template <int limit = fewItems, class Work>
void forFew(const char* label, int begin, int end, const Work& work)
{
  if (end - begin <= limit)
    Kokkos::parallel_for(label, Kokkos::RangePolicy<detail::OneThread>(begin, end), work);
  else
    Kokkos::parallel_for(label, Kokkos::RangePolicy<ExecSpace>(begin, end), work);
}

template <class Work>
void forFew(const char* label, int count, const Work& work)
{
  forFew(label, 0, count, work);
}

/// The sums that work(k, sum ...) makes for k = begin .. end - 1, in the same way. \param sums where they go:
/// numbers, or an array as Kokkos takes it
template <class Work, class... Sums>
void sumFew(const char* label, int begin, int end, const Work& work, Sums&&... sums)
{
  if (end - begin <= fewItems)
    Kokkos::parallel_reduce(label, Kokkos::RangePolicy<detail::OneThread>(begin, end), work, sums...);
  else
    Kokkos::parallel_reduce(label, Kokkos::RangePolicy<ExecSpace>(begin, end), work, sums...);
}

template <class Value, class Work>
Value sumFew(const char* label, int count, const Work& work)
{
  Value sum{};
  sumFew(label, 0, count, work, sum);
  return sum;
}

/// Counts and places in the way of Kokkos::parallel_scan.
template <class Work>
void scanFew(const char* label, int begin, int end, const Work& work, int& count)
{
  if (end - begin <= fewItems)
    Kokkos::parallel_scan(label, Kokkos::RangePolicy<detail::OneThread>(begin, end), work, count);
  else
    Kokkos::parallel_scan(label, Kokkos::RangePolicy<ExecSpace>(begin, end), work, count);
}

} // namespace Rhegma
