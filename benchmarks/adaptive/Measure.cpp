#include "adaptive/Measure.hpp"

#include "Simulation.hpp"

#include <Kokkos_Core.hpp>
#include <Teuchos_DefaultSerialComm.hpp>
#include <Teuchos_XMLParameterListHelpers.hpp>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <vector>

namespace Rhegma::benchmarks
{

namespace
{

/// One run and the times of its batches.
struct Runner
{
  std::string name;
  std::unique_ptr<Simulation> simulation;
  double best = 1e300; ///< [s per batch]
  long steps = 0;      ///< of a batch

  Runner(const std::string& which, const Teuchos::RCP<Teuchos::ParameterList>& scene) : name(which)
  {
    // A beam that comes to rest is timed no longer than it moves.
    if (scene->isSublist("Damping"))
      scene->sublist("Damping").set("Stop When Settled", false);
    double interval = 0.0;
    if (scene->isSublist("Output") && scene->sublist("Output").isType<double>("History Interval"))
      interval = scene->sublist("Output").get<double>("History Interval");
    simulation = std::make_unique<Simulation>(Teuchos::rcp(new Teuchos::SerialComm<int>()), scene);
    simulation->initialize();
    if (interval > 0.0)
      simulation->sampleEvery(interval, [](double, const Simulation::Row&) {});
  }

  void batch(double interval)
  {
    const long before = simulation->steps();
    const Kokkos::Timer timer;
    simulation->advance(simulation->time() + interval);
    Kokkos::fence();
    best = std::min(best, timer.seconds());
    steps = simulation->steps() - before;
  }
};

Runner uniform(const std::string& sceneFile, int parts)
{
  const auto scene = Teuchos::getParametersFromXmlFile(sceneFile);
  scene->remove("Adaptivity");
  scene->remove("Sub-Cycling", false);
  Teuchos::ParameterList& domain = scene->sublist("Domain");
  domain.set("Cell Size", domain.get<double>("Cell Size") / parts);
  return {"uniform, cells / " + std::to_string(parts), scene};
}

} // namespace

nlohmann::json measureAdaptive(const std::string& sceneFile, const AdaptiveEffort& effort)
{
  const auto scene = Teuchos::getParametersFromXmlFile(sceneFile);
  if (!scene->isSublist("Adaptivity"))
    throw std::invalid_argument("the scene " + sceneFile +
                                " has no section Adaptivity; write one whose cells refine, as "
                                "xml_inputs/verification/dcb_adaptive.xml");
  std::vector<Runner> runners;
  runners.emplace_back("adaptive", scene);
  for (int k = 1; k <= effort.finer; ++k)
    runners.push_back(uniform(sceneFile, 1 << k));
  for (Runner& runner : runners) // so that the body moves
  {
    runner.batch(effort.interval);
    runner.best = 1e300;
  }
  for (int round = 0; round < effort.rounds; ++round)
    for (Runner& runner : runners)
      runner.batch(effort.interval);

  nlohmann::json all;
  all["threads"] = Kokkos::DefaultExecutionSpace().concurrency();
  for (const Runner& runner : runners)
  {
    nlohmann::json entry;
    entry["name"] = runner.name;
    entry["particles"] = runner.simulation->particles();
    entry["steps"] = runner.steps;
    entry["us_per_step"] = 1e6 * runner.best / static_cast<double>(runner.steps);
    entry["seconds_per_simulated_ms"] = 1e-3 * runner.best / effort.interval;
    entry["of_adaptive"] = runner.best / runners.front().best;
    all["runs"].push_back(entry);
  }
  return all;
}

} // namespace Rhegma::benchmarks
