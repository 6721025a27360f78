#pragma once

#include <Kokkos_Core.hpp>

namespace Rhegma
{

/// Reads a number that other threads may change by atomic operations at the same time, without waiting for
/// them. Use it where an older value is good enough: the number only decreases, or all threads write the
/// same. A plain read concurrent with a write of another thread is undefined behaviour (ISO C++17,
/// intro.races).
template <class T>
KOKKOS_INLINE_FUNCTION T relaxedLoad(const T& number)
{
#if defined(__CUDA_ARCH__) || defined(__HIP_DEVICE_COMPILE__)
  return *const_cast<const volatile T*>(&number);
#else
  return __atomic_load_n(&number, __ATOMIC_RELAXED);
#endif
}

} // namespace Rhegma
