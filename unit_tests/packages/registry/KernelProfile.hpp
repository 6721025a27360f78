#pragma once
/// What Kokkos reports to a profiler: names of kernels and of memory.

#include <set>
#include <string>

namespace Rhegma
{

/// Names of the kernels that ran and of the memory that was allocated during its lifetime. One at a time.
class KernelProfile
{
public:
  KernelProfile();
  ~KernelProfile();
  KernelProfile(const KernelProfile&) = delete;
  KernelProfile& operator=(const KernelProfile&) = delete;

  const std::set<std::string>& kernels() const;
  const std::set<std::string>& memory() const;
};

} // namespace Rhegma
