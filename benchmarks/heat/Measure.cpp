#include "heat/Measure.hpp"

#include "common/Scenes.hpp"

#include <Kokkos_Core.hpp>

#include <vector>

namespace Rhegma::benchmarks
{

namespace
{

using List = Teuchos::ParameterList;

Teuchos::RCP<List> readHeated(const std::string& file, const HeatEffort& effort)
{
  const auto scene = readScene(file, "Thermal");
  if (effort.cell > 0.0)
    scene->sublist("Domain").set("Cell Size", effort.cell);
  return scene;
}

/// Takes all that is heat's out of a scene.
void removeHeat(List& scene)
{
  scene.remove("Thermal");
  const auto lists = [&](const char* section)
  {
    std::vector<List*> all;
    if (scene.isSublist(section))
      for (const auto& entry : scene.sublist(section))
        if (entry.second.isList())
          all.push_back(&scene.sublist(section).sublist(entry.first));
    return all;
  };
  for (List* material : lists("Materials"))
    for (const char* name : {"Specific Heat", "Conductivity", "Conductivity Ratios", "Thermal Expansion",
                             "Reference Temperature", "Plastic Heat Fraction", "Entropic"})
      material->remove(name, false);
  for (List* body : lists("Bodies"))
    for (const char* name : {"Temperature", "Temperature Field"})
      body->remove(name, false);
  for (List* boundary : lists("Boundaries"))
    for (const char* type : {"Temperature", "Heat Flux", "Convection"})
      if (boundary->get<std::string>("Type", "") == type)
      {
        const std::string path = boundary->name(); // "Rhegma->Boundaries->NAME"
        scene.sublist("Boundaries").remove(path.substr(path.rfind("->") + 2));
        break;
      }
}

nlohmann::json entryOf(const TimedRun& run, double seconds, double first)
{
  return {{"name", run.name}, {"us", 1e6 * seconds}, {"ratio", seconds / first}};
}

} // namespace

nlohmann::json measureHeat(const std::string& sceneFile, const HeatEffort& effort)
{
  const bool alone = !readHeated(sceneFile, effort)->sublist("Thermal").get<bool>("Mechanics", true);
  std::vector<TimedRun> runs;
  if (alone)
    for (const char* method : {"Explicit", "Super Time Stepping", "Implicit"})
    {
      const auto scene = readHeated(sceneFile, effort);
      scene->sublist("Thermal").set("Conduction", std::string(method));
      runs.emplace_back(method, scene);
    }
  else
  {
    const auto without = readHeated(sceneFile, effort);
    removeHeat(*without);
    runs.emplace_back("without heat", without);
    runs.emplace_back("with heat", readHeated(sceneFile, effort));
  }
  runs.front().advance(effort.warmUp);
  const double span = runs.front().simulation->time() / effort.warmUp; // of an explicit step
  for (std::size_t r = 1; r < runs.size(); ++r)
    runs[r].advance(alone ? 1 : effort.warmUp);
  if (alone)
    timeByTurns(runs, effort.rounds, effort.steps * span);
  else
    timeByTurns(runs, effort.rounds, effort.steps);

  const auto seconds = [&](const TimedRun& run)
  {
    return run.best([&](const Batch& batch)
                    { return batch.seconds / (alone ? double(effort.steps) : batch.steps); });
  };
  nlohmann::json all;
  all["particles"] = runs.front().simulation->particles();
  all["threads"] = Kokkos::DefaultExecutionSpace().concurrency();
  all["heat_alone"] = alone;
  for (const TimedRun& run : runs)
    all["runs"].push_back(entryOf(run, seconds(run), seconds(runs.front())));
  return all;
}

} // namespace Rhegma::benchmarks
