#include "growth/Measure.hpp"

#include "common/TimedRun.hpp"

#include <Kokkos_Core.hpp>
#include <Teuchos_XMLParameterListHelpers.hpp>

#include <stdexcept>
#include <vector>

namespace Rhegma::benchmarks
{

namespace
{

using Scene = Teuchos::RCP<Teuchos::ParameterList>;

/// More than any front has [J/m2].
constexpr const char* unreached = "1e30";

Scene readScene(const std::string& file, const GrowthEffort& effort)
{
  const Scene scene = Teuchos::getParametersFromXmlFile(file);
  if (!scene->isSublist("Propagation"))
    throw std::invalid_argument(file + " has no section Propagation");
  if (effort.cell > 0.0)
    scene->sublist("Domain").set("Cell Size", effort.cell);
  scene->remove("Reference", false);
  return scene;
}

TimedRun makeRun(const std::string& name, const Scene& scene)
{
  double samples = 0.0;
  if (scene->isSublist("Output") && scene->sublist("Output").isType<double>("History Interval"))
    samples = scene->sublist("Output").get<double>("History Interval");
  TimedRun run(name, scene);
  if (samples > 0.0)
    run.simulation->sampleEvery(samples, [](double, const Simulation::Row&) {});
  return run;
}

TimedRun unreachedRun(const std::string& file, const GrowthEffort& effort)
{
  const Scene scene = readScene(file, effort);
  Teuchos::ParameterList& propagation = scene->sublist("Propagation");
  propagation.set("Toughness", std::string(unreached));
  propagation.remove("Initiation Toughness", false);
  propagation.remove("Arrest Toughness", false);
  return makeRun("fronts driven and held", scene);
}

long increments(const TimedRun& run)
{
  const nlohmann::json report = run.simulation->report();
  long sum = 0;
  for (const nlohmann::json& crack : report.at("cracks"))
    for (const nlohmann::json& front : crack.at("fronts"))
      sum += front.at("increments").get<long>();
  return sum;
}

} // namespace

nlohmann::json measureGrowth(const std::string& sceneFile, const GrowthEffort& effort)
{
  const Scene held = readScene(sceneFile, effort);
  const double start = held->sublist("Propagation").get<double>("Start Time", 0.0);
  held->remove("Propagation");
  std::vector<TimedRun> runs;
  runs.push_back(makeRun("cracks held", held));
  runs.push_back(unreachedRun(sceneFile, effort));
  runs.push_back(makeRun("cracks that run", readScene(sceneFile, effort)));
  TimedRun& running = runs.back();
  for (TimedRun& run : runs)
    run.simulation->advance(start);
  const double span = runs.front().simulation->stableTimeStep();
  for (TimedRun& run : runs)
    run.simulation->advance(start + effort.warmUp * span);
  const long before = increments(running);
  timeByTurns(runs, effort.rounds, effort.steps * span);
  const long made = increments(running) - before;
  if (made == 0)
    throw std::invalid_argument("no front of " + sceneFile +
                                " advances in what is timed; let it go on with more --steps, or start later "
                                "with --warm-up");

  const auto perTime = [&](const TimedRun& run)
  { return run.best([&](const Batch& batch) { return batch.seconds / effort.steps; }); };
  const auto perStep = [](const TimedRun& run)
  { return run.best([](const Batch& batch) { return batch.seconds / batch.steps; }); };
  nlohmann::json all;
  all["particles"] = running.simulation->particles();
  all["threads"] = Kokkos::DefaultExecutionSpace().concurrency();
  all["increments"] = made;
  for (const TimedRun& run : runs)
    all["runs"].push_back({{"name", run.name},
                           {"us", 1e6 * perTime(run)},
                           {"ratio", perTime(run) / perTime(runs.front())},
                           {"ratio_of_steps", perStep(run) / perStep(runs.front())}});
  return all;
}

} // namespace Rhegma::benchmarks
