/// The program: reads a scene and runs it.

#include "program/LawEnds.hpp"
#include "program/Options.hpp"
#include "program/RunScene.hpp"
#include "program/Runtime.hpp"

#include <Kokkos_Core.hpp>

#include <iostream>
#include <mpi.h>
#include <new>
#include <stdexcept>

namespace
{

using namespace Rhegma::program;

/// Starts Kokkos, which reports errors of its own arguments.
void startKokkos(const char* program, const std::vector<std::string>& forKokkos)
{
  // Its warning (more threads than cores) is intended with several ranks.
  std::vector<std::string> all = forKokkos;
  all.emplace_back("--kokkos-disable-warnings");
  const KokkosArguments arguments(program, all);
  try
  {
    Kokkos::initialize(arguments.count(), arguments.values());
  }
  catch (const std::exception& error)
  {
    throw UsageError("Kokkos rejects its arguments (" + firstLine(error.what()) +
                     "); write for example --kokkos-num-threads=2, or leave them out");
  }
}

/// Other ranks may wait for this one: ends them too.
void endAlone(const std::exception& error)
{
  int size = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  if (size == 1)
    return;
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr)
  {
    std::cerr << "rhegma: there is not enough memory for this scene on one of the ranks; use larger cells "
                 "(Domain > Cell Size)\n";
    MPI_Abort(MPI_COMM_WORLD, exitStopped);
  }
  std::cerr << "rhegma: a defect of the program: " << error.what() << "\n";
  MPI_Abort(MPI_COMM_WORLD, exitDefect);
}

/// \return the program's exit code; every exception ends here, so that Kokkos and MPI are always closed
int start(int argc, char** argv, std::ostream& out, std::ostream& err)
{
  int code = exitDefect;
  try
  {
    std::vector<std::string> forKokkos;
    const Options options = readOptions({argv + 1, argv + argc}, forKokkos);
    startKokkos(argv[0], forKokkos);
    sayWhichLawEnds(options.action == Options::Action::Run ? exitStopped : exitWrongScene);
    code = run(options, out, err);
  }
  catch (const UsageError& error)
  {
    err << "rhegma: " << error.what() << "\n";
    code = exitWrongScene;
  }
  catch (const std::exception& error)
  {
    endAlone(error);
    err << "rhegma: a defect of the program: " << error.what() << "\n";
  }
  if (Kokkos::is_initialized())
    Kokkos::finalize();
  return code;
}

} // namespace

int main(int argc, char** argv)
{
  bindThreads(argv);
  startWithoutNetwork();
  outliveReaders();
  startWithoutDisplay();
  MPI_Init(&argc, &argv);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  // Every rank has the same output; one prints it.
  std::ostream silence(nullptr);
  const int code = start(argc, argv, rank == 0 ? std::cout : silence, rank == 0 ? std::cerr : silence);
  MPI_Finalize();
  return code;
}
