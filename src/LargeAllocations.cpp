/// Memory of large arrays in huge pages, for the program alone.
///
/// A processor finds a page of 4 kB anew for every few numbers of a large matrix, and the system clears each
/// of them when it is first written: without huge pages a third of the time of an equilibrium of a million
/// particles goes there. Linux gives huge pages to memory for which a program asks
/// (/sys/kernel/mm/transparent_hugepage/enabled = madvise, the default of most distributions). Arrays are
/// allocated by Kokkos and Trilinos, so malloc is the place to ask. RHEGMA_HUGE_PAGES=0 in the environment
/// switches this off.

#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <cstring>

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)

#include <malloc.h>
#include <sys/mman.h>

// The name under which the C library has its malloc for those that replace it.
extern "C" void* __libc_malloc(std::size_t size); // NOLINT(bugprone-reserved-identifier)

namespace
{

constexpr std::size_t hugePage = std::size_t(1) << 21; ///< of x86-64, and of ARM with pages of 4 kB
constexpr std::size_t large = 2 * hugePage;            ///< least size of an array that gets them

bool isOn()
{
  static const bool on = []
  {
    const char* const chosen = std::getenv("RHEGMA_HUGE_PAGES");
    return chosen == nullptr || std::strcmp(chosen, "0") != 0;
  }();
  return on;
}

} // namespace

/// As that of the C library, which frees the memory and serves all other requests.
extern "C" void* malloc(std::size_t size) noexcept
{
  if (size < large || !isOn())
    return __libc_malloc(size);
  void* const memory = memalign(hugePage, size);
  const int error = errno;
  if (memory != nullptr)
    (void)madvise(memory, size, MADV_HUGEPAGE); // an older kernel has none: the memory is as good
  errno = error;
  return memory;
}

#endif
