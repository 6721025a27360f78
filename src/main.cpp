/// Read a scene, run it, tell the user.

#include "program/Options.hpp"
#include "program/RunScene.hpp"
#include "program/Runtime.hpp"

#include <Kokkos_Core.hpp>

#include <iostream>
#include <mpi.h>
#include <stdexcept>

int main(int argc, char** argv)
{
  using namespace Rhegma::program;
  bindThreads(argv);
  int code = exitDefect;
  MPI_Init(&argc, &argv);
  try
  {
    std::vector<std::string> forKokkos;
    const Options options = readOptions({argv + 1, argv + argc}, forKokkos);
    const KokkosArguments arguments(argv[0], forKokkos);
    Kokkos::initialize(arguments.count(), arguments.values());
    code = run(options, std::cout, std::cerr);
    Kokkos::finalize();
  }
  catch (const UsageError& error)
  {
    std::cerr << "rhegma: " << error.what() << "\n";
    code = exitWrongScene;
  }
  catch (const std::exception& error)
  {
    std::cerr << "rhegma: a defect of the program: " << error.what() << "\n";
  }
  MPI_Finalize();
  return code;
}
