#include "KernelProfile.hpp"

#include <Kokkos_Core.hpp>

#include <cstdint>

namespace Rhegma
{

namespace
{

std::set<std::string> ran, allocated;

void noteKernel(const char* name, const std::uint32_t, std::uint64_t*) { ran.insert(name); }

void noteMemory(Kokkos::Tools::SpaceHandle, const char* label, const void*, const std::uint64_t)
{
  allocated.insert(label);
}

void listen(Kokkos_Profiling_beginFunction kernel, Kokkos_Profiling_allocateDataFunction memory)
{
  Kokkos::Tools::Experimental::set_begin_parallel_for_callback(kernel);
  Kokkos::Tools::Experimental::set_begin_parallel_reduce_callback(kernel);
  Kokkos::Tools::Experimental::set_begin_parallel_scan_callback(kernel);
  Kokkos::Tools::Experimental::set_allocate_data_callback(memory);
}

} // namespace

KernelProfile::KernelProfile()
{
  ran.clear();
  allocated.clear();
  listen(noteKernel, noteMemory);
}

KernelProfile::~KernelProfile() { listen(nullptr, nullptr); }

const std::set<std::string>& KernelProfile::kernels() const { return ran; }
const std::set<std::string>& KernelProfile::memory() const { return allocated; }

} // namespace Rhegma
