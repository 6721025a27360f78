/// MPI and Kokkos round a fuzzer.

#include <Kokkos_Core.hpp>

#include <mpi.h>

/// What MPI keeps for good is not ours.
extern "C" const char* __lsan_default_suppressions()
{
  return "leak:libmpi\nleak:libopen-rte\nleak:libopen-pal\nleak:libpmix\nleak:mca_\n";
}

/// HDF5 asks whether there is so much memory as a file says and takes no for an answer.
extern "C" const char* __asan_default_options() { return "allocator_may_return_null=1"; }

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv)
{
  MPI_Init(argc, argv);
  Kokkos::initialize();
  return 0;
}
