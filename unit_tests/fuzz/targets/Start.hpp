#pragma once
/// MPI and Kokkos round a fuzzer.

#include <Kokkos_Core.hpp>

#include <mpi.h>

/// What MPI keeps for good is not ours.
extern "C" inline const char* __lsan_default_suppressions()
{
  return "leak:libmpi\nleak:libopen-rte\nleak:libopen-pal\nleak:libpmix\nleak:mca_\n";
}

extern "C" inline int LLVMFuzzerInitialize(int* argc, char*** argv)
{
  MPI_Init(argc, argv);
  Kokkos::initialize();
  return 0;
}
