/// A block on bristles, pushed to the right: runs a scene with an effect of its own, and checks it.

#include "Bristles.hpp"

#include <Simulation.hpp>
#include <plan/KnownEffects.hpp>

#include <Teuchos_DefaultMpiComm.hpp>

#include <cmath>
#include <iostream>

using namespace Rhegma;

namespace
{

/// The block oscillates as a whole: its displacement is v / w sin(w t), w^2 = stiffness.
int run(const std::string& file)
{
  addEffect(bristles());
  const auto scene = Simulation::readScene(file);
  const double end = scene->sublist("Time").get<double>("Final Time");
  Simulation simulation(Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD)), scene);
  simulation.initialize();
  simulation.advance(end);
  const double speed = scene->sublist("Bodies").sublist("Block").get<Teuchos::Array<double>>("Velocity")[0];
  const double w = std::sqrt(scene->sublist("Bristles").get<double>("Stiffness"));
  const double expected = speed / w * std::sin(w * end);
  const double moved = simulation.particleField(fields::position).values[0] -
                       simulation.particleField(fields::reference).values[0];
  std::cout << "moved " << moved << " m, " << expected << " m expected\n";
  // Force and motion alternate, so the position lags by at most half a step at the initial speed.
  return std::abs(moved - expected) < 0.5 * speed * simulation.stableTimeStep() ? 0 : 1;
}

} // namespace

int main(int argc, char** argv)
{
  MPI_Init(&argc, &argv);
  int code = 1;
  {
    const Kokkos::ScopeGuard kokkos(argc, argv);
    try
    {
      code = run(argc == 2 ? argv[1] : "block.xml");
    }
    catch (const std::exception& error)
    {
      std::cerr << error.what() << "\n";
    }
  }
  MPI_Finalize();
  return code;
}
