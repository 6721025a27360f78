#include "combustion/Measure.hpp"

#include "common/TimedRun.hpp"

#include <Kokkos_Core.hpp>
#include <Teuchos_XMLParameterListHelpers.hpp>

#include <stdexcept>
#include <vector>

namespace Rhegma::benchmarks
{

namespace
{

using List = Teuchos::ParameterList;

Teuchos::RCP<List> readScene(const std::string& file)
{
  const auto scene = Teuchos::getParametersFromXmlFile(file);
  if (!scene->isSublist("Combustion"))
    throw std::invalid_argument(file + " has no section Combustion");
  for (const char* name : {"Reference", "Propagation"})
    scene->remove(name, false);
  return scene;
}

Teuchos::RCP<List> withModel(const std::string& file, const std::string& model)
{
  const auto scene = readScene(file);
  List& combustion = scene->sublist("Combustion");
  std::vector<std::string> cracks;
  for (const auto& entry : combustion)
    cracks.push_back(entry.first);
  for (const std::string& crack : cracks)
  {
    combustion.sublist(crack).set("Gas Model", model);
    if (model == "Uniform")
      for (const char* name : {"Viscosity", "Friction Factor"})
        combustion.sublist(crack).remove(name, false);
  }
  return scene;
}

} // namespace

nlohmann::json measureCombustion(const std::string& sceneFile, const CombustionEffort& effort)
{
  const auto without = readScene(sceneFile);
  const bool plane = without->sublist("Domain").get<int>("Dimension", 2) == 2;
  without->remove("Combustion");
  std::vector<TimedRun> runs;
  runs.emplace_back("without combustion", without);
  runs.emplace_back("gas of one pressure", withModel(sceneFile, "Uniform"));
  if (plane)
    runs.emplace_back("gas that flows", withModel(sceneFile, "Flow"));
  for (TimedRun& run : runs)
    run.advance(effort.warmUp);
  const double span = runs.front().simulation->time() / effort.warmUp;
  timeByTurns(runs, effort.rounds, effort.steps * span);

  const auto perTime = [&](const TimedRun& run)
  { return run.best([&](const Batch& batch) { return batch.seconds / effort.steps; }); };
  const auto perStep = [&](const TimedRun& run)
  { return run.best([](const Batch& batch) { return batch.seconds / batch.steps; }); };
  nlohmann::json all;
  all["particles"] = runs.front().simulation->particles();
  all["threads"] = Kokkos::DefaultExecutionSpace().concurrency();
  for (const TimedRun& run : runs)
    all["runs"].push_back({{"name", run.name},
                           {"us", 1e6 * perTime(run)},
                           {"ratio", perTime(run) / perTime(runs.front())},
                           {"ratio_of_steps", perStep(run) / perStep(runs.front())}});
  return all;
}

} // namespace Rhegma::benchmarks
