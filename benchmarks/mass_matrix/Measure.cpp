#include "mass_matrix/Measure.hpp"

#include "common/TimedRun.hpp"

#include <Kokkos_Core.hpp>
#include <Teuchos_XMLParameterListHelpers.hpp>

#include <vector>

namespace Rhegma::benchmarks
{

namespace
{

TimedRun makeRun(const std::string& name, const std::string& type, const std::string& sceneFile)
{
  const auto scene = Teuchos::getParametersFromXmlFile(sceneFile);
  scene->sublist("Mass Matrix").set("Type", type);
  if (type == "FMPM")
    scene->sublist("Mass Matrix").set("Order", 2);
  return {name, scene};
}

double secondsPerStep(const TimedRun& run)
{
  return run.best([](const Batch& batch) { return batch.seconds / batch.steps; });
}

} // namespace

nlohmann::json measureMassMatrices(const std::string& sceneFile, const MassMatrixEffort& effort)
{
  std::vector<TimedRun> runs;
  runs.push_back(makeRun("Lumped", "Lumped", sceneFile));
  runs.push_back(makeRun("FMPM(2)", "FMPM", sceneFile));
  runs.push_back(makeRun("Partial", "Partial", sceneFile));
  runs.push_back(makeRun("Full", "Full", sceneFile));
  for (TimedRun& run : runs)
    run.advance(effort.warmUp);
  timeByTurns(runs, effort.rounds, effort.steps);

  nlohmann::json all;
  all["particles"] = runs.front().simulation->particles();
  all["threads"] = Kokkos::DefaultExecutionSpace().concurrency();
  for (const TimedRun& run : runs)
  {
    nlohmann::json entry;
    entry["name"] = run.name;
    entry["us_per_step"] = 1e6 * secondsPerStep(run);
    entry["of_lumped"] = secondsPerStep(run) / secondsPerStep(runs.front());
    const nlohmann::json report = run.simulation->report().at("mass_matrix");
    for (const char* key : {"cg_iterations_mean", "cg_iterations_max", "coupled_nodes"})
      if (report.contains(key))
        entry[key] = report.at(key);
    all["matrices"].push_back(entry);
  }
  return all;
}

} // namespace Rhegma::benchmarks
