#include "combustion/Measure.hpp"

#include "common/Scenes.hpp"

#include <vector>

namespace Rhegma::benchmarks
{

namespace
{

using List = Teuchos::ParameterList;

/// Of a crack whose gas has none at first [Pa].
constexpr double usualPressure = 1e6;

/// Along each axis [m/s]: what faces get from some megapascals, p / (rho c), in a solid.
constexpr double usualSpeed = 1.0;

Teuchos::RCP<List> readHeld(const std::string& file)
{
  const auto scene = readScene(file, "Combustion");
  scene->remove("Propagation", false);
  return scene;
}

/// The same bodies in motion, so that particles lie anywhere in their cells; nothing acts on the cracks.
Teuchos::RCP<List> inMotion(const std::string& file)
{
  const auto scene = readHeld(file);
  scene->remove("Combustion");
  const int dimension = scene->sublist("Domain").get<int>("Dimension", 2);
  List& bodies = scene->sublist("Bodies");
  for (const auto& entry : bodies)
    if (!bodies.sublist(entry.first).isParameter("Velocity"))
      bodies.sublist(entry.first)
          .set("Velocity", Teuchos::Array<double>(static_cast<std::size_t>(dimension), usualSpeed));
  return scene;
}

std::vector<std::string> cracksOf(const List& combustion)
{
  std::vector<std::string> cracks;
  for (const auto& entry : combustion)
    cracks.push_back(entry.first);
  return cracks;
}

/// The same cracks, opened by the pressure that their gas has at first instead of by gas.
Teuchos::RCP<List> withPressure(const std::string& file)
{
  const auto scene = readHeld(file);
  List& combustion = scene->sublist("Combustion");
  for (const std::string& crack : cracksOf(combustion))
  {
    const auto pressure = combustion.sublist(crack).get<double>("Initial Pressure", usualPressure);
    scene->sublist("Face Pressure").sublist(crack).set("Pressure", std::to_string(pressure));
  }
  scene->remove("Combustion");
  return scene;
}

Teuchos::RCP<List> withModel(const std::string& file, const std::string& model)
{
  const auto scene = readHeld(file);
  List& combustion = scene->sublist("Combustion");
  for (const std::string& crack : cracksOf(combustion))
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
  const auto without = readHeld(sceneFile);
  const bool plane = without->sublist("Domain").get<int>("Dimension", 2) == 2;
  without->remove("Combustion");
  std::vector<TimedRun> runs;
  runs.emplace_back("without combustion", without);
  runs.emplace_back("in motion without", inMotion(sceneFile));
  runs.emplace_back("pressure without gas", withPressure(sceneFile));
  runs.emplace_back("gas of one pressure", withModel(sceneFile, "Uniform"));
  if (plane)
    runs.emplace_back("gas that flows", withModel(sceneFile, "Flow"));
  for (TimedRun& run : runs)
    run.advance(effort.warmUp);
  for (int round = 0; round < effort.rounds; ++round)
    for (TimedRun& run : runs)
      run.timeWhole(effort.steps);
  return nextToFirst(runs, effort.steps);
}

} // namespace Rhegma::benchmarks
