#include "mass_matrix/Measure.hpp"

#include "Simulation.hpp"

#include <Kokkos_Core.hpp>
#include <Teuchos_DefaultSerialComm.hpp>
#include <Teuchos_XMLParameterListHelpers.hpp>

#include <algorithm>
#include <memory>
#include <vector>

namespace Rhegma::benchmarks
{

namespace
{

/// One matrix and the times of its batches.
struct Runner
{
  std::string name;
  std::unique_ptr<Simulation> simulation;
  double best = 1e300; ///< [s per step]

  Runner(const std::string& which, const std::string& type, const std::string& sceneFile, int warmUp)
      : name(which)
  {
    const auto scene = Teuchos::getParametersFromXmlFile(sceneFile);
    scene->sublist("Mass Matrix").set("Type", type);
    if (type == "FMPM")
      scene->sublist("Mass Matrix").set("Order", 2);
    // A beam that comes to rest is timed no longer than it moves.
    scene->sublist("Damping").set("Stop When Settled", false);
    simulation = std::make_unique<Simulation>(Teuchos::rcp(new Teuchos::SerialComm<int>()), scene);
    simulation->initialize();
    advance(warmUp);
  }

  void advance(int steps) { simulation->advance(simulation->time() + steps * simulation->stableTimeStep()); }

  void batch(int steps)
  {
    const long before = simulation->steps();
    const Kokkos::Timer timer;
    advance(steps);
    best = std::min(best, timer.seconds() / static_cast<double>(simulation->steps() - before));
  }
};

} // namespace

nlohmann::json measureMassMatrices(const std::string& sceneFile, const MassMatrixEffort& effort)
{
  std::vector<Runner> runners;
  runners.emplace_back("Lumped", "Lumped", sceneFile, effort.warmUp);
  runners.emplace_back("FMPM(2)", "FMPM", sceneFile, effort.warmUp);
  runners.emplace_back("Partial", "Partial", sceneFile, effort.warmUp);
  runners.emplace_back("Full", "Full", sceneFile, effort.warmUp);
  for (int round = 0; round < effort.rounds; ++round)
    for (Runner& runner : runners)
      runner.batch(effort.steps);

  nlohmann::json all;
  all["particles"] = runners.front().simulation->particles();
  all["threads"] = Kokkos::DefaultExecutionSpace().concurrency();
  for (const Runner& runner : runners)
  {
    nlohmann::json entry;
    entry["name"] = runner.name;
    entry["us_per_step"] = 1e6 * runner.best;
    entry["of_lumped"] = runner.best / runners.front().best;
    const nlohmann::json report = runner.simulation->report().at("mass_matrix");
    for (const char* key : {"cg_iterations_mean", "cg_iterations_max", "coupled_nodes"})
      if (report.contains(key))
        entry[key] = report.at(key);
    all["matrices"].push_back(entry);
  }
  return all;
}

} // namespace Rhegma::benchmarks
