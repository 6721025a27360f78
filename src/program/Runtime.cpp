#include "program/Runtime.hpp"

#include <Kokkos_Macros.hpp>

#include <csignal>
#include <cstdlib>
#include <unistd.h>

namespace Rhegma::program
{

namespace
{

/// Whether mpirun has started the program as one of its ranks.
bool isUnderMpi()
{
  return std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr || std::getenv("PMIX_RANK") != nullptr ||
         std::getenv("PMI_SIZE") != nullptr;
}

} // namespace

void bindThreads(char** argv)
{
#ifdef KOKKOS_ENABLE_OPENMP
  if (std::getenv("OMP_PROC_BIND") != nullptr)
    return;
  const bool underMpi = isUnderMpi();
  setenv("OMP_PROC_BIND", underMpi ? "false" : "spread", 1);
  if (!underMpi)
    setenv("OMP_PLACES", "threads", 0);
  execv("/proc/self/exe", argv);
  // Where a program can't start itself again, threads stay unbound.
#else
  (void)argv;
#endif
}

void startWithoutDisplay() { setenv("HWLOC_COMPONENTS", "-gl", 0); }

void startWithoutNetwork()
{
  if (isUnderMpi())
    return;
  setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
  setenv("OMPI_MCA_pml", "ob1", 0); // else UCX looks for devices, 0.2 s
}

void outliveReaders() { std::signal(SIGPIPE, SIG_IGN); }

std::string firstLine(const std::string& message) { return message.substr(0, message.find('\n')); }

KokkosArguments::KokkosArguments(const std::string& program, const std::vector<std::string>& arguments)
    : texts_{program}
{
  texts_.insert(texts_.end(), arguments.begin(), arguments.end());
  for (std::string& text : texts_)
    pointers_.push_back(text.data());
  pointers_.push_back(nullptr);
  count_ = static_cast<int>(texts_.size());
}

} // namespace Rhegma::program
