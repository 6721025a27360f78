/// Memory of large arrays in huge pages, for the program alone.
///
/// A processor finds a page of 4 kB anew for every few numbers of a large matrix, and the system clears each
/// of them when it is first written: without huge pages a third of the time of an equilibrium of a million
/// particles goes there. Linux gives huge pages to memory for which a program asks
/// (/sys/kernel/mm/transparent_hugepage/enabled = madvise, the default of most distributions). Arrays are
/// allocated by Kokkos and Trilinos, so malloc is the place to ask: that of the C library, or of another
/// allocator that is loaded before it. RHEGMA_HUGE_PAGES=0 in the environment switches this off.

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>

// Sanitizers have a malloc of their own.
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
#define RHEGMA_KEEP_MALLOC
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define RHEGMA_KEEP_MALLOC
#endif

#if defined(__GLIBC__) && !defined(RHEGMA_KEEP_MALLOC)

#include <dlfcn.h>
#include <sys/mman.h>

// The name under which the C library has its malloc for those that replace it.
extern "C" void* __libc_malloc(std::size_t size); // NOLINT(bugprone-reserved-identifier)

namespace
{

using Malloc = void* (*)(std::size_t);

constexpr std::uintptr_t hugePage = std::uintptr_t(1) << 21; ///< of x86-64, and of ARM with pages of 4 kB
constexpr std::size_t large = 2 * hugePage;                  ///< least size of an array that gets them

bool isOn()
{
  static const bool on = []
  {
    const char* const chosen = std::getenv("RHEGMA_HUGE_PAGES");
    return chosen == nullptr || std::strcmp(chosen, "0") != 0;
  }();
  return on;
}

/// The malloc that the program would have without this one.
Malloc nextMalloc()
{
  static Malloc next = nullptr;
  static bool looks = false;
  if (next == nullptr && !looks) // the search may allocate
  {
    looks = true;
    next = reinterpret_cast<Malloc>(dlsym(RTLD_NEXT, "malloc"));
  }
  return next == nullptr ? __libc_malloc : next;
}

} // namespace

extern "C" void* malloc(std::size_t size) noexcept
{
  void* const memory = nextMalloc()(size);
  if (size < large || memory == nullptr || !isOn())
    return memory;
  const auto address = reinterpret_cast<std::uintptr_t>(memory);
  const std::uintptr_t first = (address + hugePage - 1) & ~(hugePage - 1);
  const std::uintptr_t end = (address + size) & ~(hugePage - 1);
  const int error = errno;
  if (end > first) // an older kernel has none: the memory is as good
    (void)madvise(static_cast<char*>(memory) + (first - address), end - first, MADV_HUGEPAGE);
  errno = error;
  return memory;
}

#endif
