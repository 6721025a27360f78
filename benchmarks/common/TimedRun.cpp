#include "common/TimedRun.hpp"

#include <Kokkos_Core.hpp>
#include <Teuchos_DefaultSerialComm.hpp>

#include <ctime>
#include <utility>

namespace Rhegma::benchmarks
{

TimedRun::TimedRun(std::string which, const Teuchos::RCP<Teuchos::ParameterList>& scene,
                   const Teuchos::RCP<const Teuchos::Comm<int>>& comm)
    : name(std::move(which))
{
  if (scene->isSublist("Damping"))
    scene->sublist("Damping").set("Stop When Settled", false);
  using Comm = Teuchos::RCP<const Teuchos::Comm<int>>;
  const Comm alone = Teuchos::rcp(new Teuchos::SerialComm<int>());
  simulation = std::make_unique<Simulation>(comm.is_null() ? alone : comm, scene);
  simulation->initialize();
}

double TimedRun::lasting(int steps) const { return steps * simulation->stableTimeStep(); }

void TimedRun::advance(int steps) { simulation->advance(simulation->time() + lasting(steps)); }

void TimedRun::time(int steps) { timeUntil(simulation->time() + lasting(steps)); }

void TimedRun::time(double simulated) { timeUntil(simulation->time() + simulated); }

void TimedRun::timeWhole(int steps)
{
  timeUntil(simulation->time() + (steps - 0.5) * simulation->stableTimeStep());
}

void TimedRun::timeUntil(double end)
{
  const double begin = simulation->time();
  const auto steps = static_cast<double>(simulation->steps());
  const double particleSteps = simulation->particleSteps();
  const std::clock_t clock = std::clock();
  const Kokkos::Timer timer;
  simulation->advance(end);
  batches.push_back({timer.seconds(), static_cast<double>(std::clock() - clock) / CLOCKS_PER_SEC,
                     simulation->time() - begin, static_cast<double>(simulation->steps()) - steps,
                     simulation->particleSteps() - particleSteps});
}

} // namespace Rhegma::benchmarks
