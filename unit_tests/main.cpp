#include <Kokkos_Core.hpp>
#include <gtest/gtest.h>
#include <mpi.h>

/// Every test program runs inside MPI and Kokkos, as the program does.
int main(int argc, char** argv)
{
  MPI_Init(&argc, &argv);
  int status = 1;
  {
    const Kokkos::ScopeGuard kokkos(argc, argv);
    testing::InitGoogleTest(&argc, argv);
    status = RUN_ALL_TESTS();
  }
  MPI_Finalize();
  return status;
}
