#include "growth/Measure.hpp"

#include "common/Scenes.hpp"

#include <stdexcept>
#include <vector>

namespace Rhegma::benchmarks
{

namespace
{

using Scene = Teuchos::RCP<Teuchos::ParameterList>;

/// More than any front has [J/m2].
constexpr const char* unreached = "1e30";

Scene readGrowing(const std::string& file, const GrowthEffort& effort)
{
  const Scene scene = readScene(file, "Propagation");
  if (effort.cell > 0.0)
    scene->sublist("Domain").set("Cell Size", effort.cell);
  return scene;
}

TimedRun unreachedRun(const std::string& file, const GrowthEffort& effort)
{
  const Scene scene = readGrowing(file, effort);
  Teuchos::ParameterList& propagation = scene->sublist("Propagation");
  propagation.set("Toughness", std::string(unreached));
  propagation.remove("Initiation Toughness", false);
  propagation.remove("Arrest Toughness", false);
  return sampledRun("fronts driven and held", scene);
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
  const Scene held = readGrowing(sceneFile, effort);
  const double start = held->sublist("Propagation").get<double>("Start Time", 0.0);
  held->remove("Propagation");
  std::vector<TimedRun> runs;
  runs.push_back(sampledRun("cracks held", held));
  runs.push_back(unreachedRun(sceneFile, effort));
  runs.push_back(sampledRun("cracks that run", readGrowing(sceneFile, effort)));
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

  nlohmann::json all = nextToFirst(runs, effort.steps);
  all["increments"] = made;
  return all;
}

} // namespace Rhegma::benchmarks
