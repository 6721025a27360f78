/// Rhegma inside an application: runs a scene and says whether its first crack would run.
///
///     will_it_run SCENE.xml TOUGHNESS     [J/m2]
///
/// With OpenMP on a machine with other work, start it with OMP_WAIT_POLICY=passive
/// (docs/tutorials/your-own-program.md).

#include <Simulation.hpp>

#include <Kokkos_Core.hpp>
#include <Teuchos_DefaultMpiComm.hpp>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <iostream>

namespace
{

/// The first J integral of a sample [J/m2].
double energyRelease(const Rhegma::Simulation::Row& row)
{
  for (const auto& [name, value] : row)
    if (name.size() > 4 && name.substr(name.size() - 4) == ".G_J")
      return value;
  throw std::invalid_argument("the scene has no section Energy Release, or no crack front");
}

int willItRun(const std::string& file, double toughness)
{
  const auto comm = Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD));
  const auto scene = Rhegma::Simulation::readScene(file);
  const double end = scene->sublist("Time").get<double>("Final Time");

  Rhegma::Simulation simulation(comm, scene); // throws std::invalid_argument for a wrong scene
  simulation.initialize();
  double largest = 0.0;
  simulation.sampleEvery(end / 400.0, [&](double, const Rhegma::Simulation::Row& row)
                         { largest = std::max(largest, energyRelease(row)); });
  simulation.advance(end); // throws Rhegma::RunError where it can't go on

  const double last = energyRelease(simulation.observe());
  std::cout << "G at most " << largest << ", " << (simulation.settled() ? "at rest " : "at last ") << last
            << " J/m2: the crack " << (last > toughness ? "runs" : "stays") << "\n";
  return 0;
}

} // namespace

int main(int argc, char** argv)
{
  if (argc != 3)
  {
    std::cerr << "usage: will_it_run SCENE.xml TOUGHNESS\n";
    return 1;
  }
  int code = 1;
  MPI_Init(&argc, &argv);
  {
    const Kokkos::ScopeGuard kokkos(argc, argv);
    try
    {
      code = willItRun(argv[1], std::atof(argv[2]));
    }
    catch (const Rhegma::RunError& error)
    {
      std::cerr << error.what() << "\n";
      code = 2;
    }
    catch (const std::exception& error)
    {
      std::cerr << error.what() << "\n";
    }
  }
  MPI_Finalize();
  return code;
}
