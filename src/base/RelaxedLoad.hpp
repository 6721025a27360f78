#pragma once

#include <Kokkos_Core.hpp>

namespace Rhegma
{

/// A number that other threads may be changing by atomic operations just now, without waiting for them: what
/// it was a moment ago serves as well, as where a number only ever falls, or all write the same. A plain read
/// next to a write of another thread has no defined outcome (ISO C++17, intro.races).
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
