#include "adaptive/Measure.hpp"

#include "common/Scenes.hpp"

#include <Kokkos_Core.hpp>

#include <vector>

namespace Rhegma::benchmarks
{

namespace
{

using Scene = Teuchos::RCP<Teuchos::ParameterList>;

Scene readRefined(const std::string& file)
{
  return readScene(file, "Adaptivity",
                   "write one whose cells refine, as xml_inputs/verification/dcb_adaptive.xml");
}

TimedRun uniform(const std::string& file, int parts)
{
  const Scene scene = readRefined(file);
  scene->remove("Adaptivity");
  scene->remove("Sub-Cycling", false);
  Teuchos::ParameterList& domain = scene->sublist("Domain");
  domain.set("Cell Size", domain.get<double>("Cell Size") / parts);
  return sampledRun("uniform, cells / " + std::to_string(parts), scene);
}

/// \param everywhere whether large cells take substeps too
TimedRun withLevels(const std::string& file, int levels, bool everywhere, double frontCells)
{
  const Scene scene = readRefined(file);
  scene->sublist("Adaptivity").set("Maximum Level", levels);
  if (frontCells > 0.0)
    scene->sublist("Adaptivity").set("Front Cells", frontCells);
  scene->remove("Sub-Cycling", false);
  if (!everywhere)
    scene->sublist("Sub-Cycling").set("Levels", levels);
  return sampledRun("levels " + std::to_string(levels), scene);
}

void measure(std::vector<TimedRun>& runs, const AdaptiveEffort& effort)
{
  timeByTurns(runs, 1, effort.interval); // so that the body moves
  for (TimedRun& run : runs)
    run.batches.clear();
  timeByTurns(runs, effort.rounds, effort.interval);
}

nlohmann::json timesOf(const TimedRun& run, double interval)
{
  return {{"particles", run.simulation->particles()},
          {"steps", run.batches.back().steps},
          {"particle_steps", run.batches.back().particleSteps},
          {"us_per_step", 1e6 * leastSeconds(run) / run.batches.back().steps},
          {"seconds_per_simulated_ms", 1e-3 * leastSeconds(run) / interval}};
}

} // namespace

nlohmann::json measureAdaptive(const std::string& sceneFile, const AdaptiveEffort& effort)
{
  std::vector<TimedRun> runs;
  runs.push_back(sampledRun("adaptive", readRefined(sceneFile)));
  for (int k = 1; k <= effort.finer; ++k)
    runs.push_back(uniform(sceneFile, 1 << k));
  measure(runs, effort);

  nlohmann::json all;
  all["threads"] = Kokkos::DefaultExecutionSpace().concurrency();
  for (const TimedRun& run : runs)
  {
    nlohmann::json entry = timesOf(run, effort.interval);
    entry["name"] = run.name;
    entry["of_adaptive"] = leastSeconds(run) / leastSeconds(runs.front());
    all["runs"].push_back(entry);
  }
  return all;
}

nlohmann::json measureSmallSteps(const std::string& sceneFile, const AdaptiveEffort& effort)
{
  std::vector<TimedRun> runs;
  for (int levels = 1; levels <= effort.levels; ++levels)
    for (const bool everywhere : {false, true})
      runs.push_back(withLevels(sceneFile, levels, everywhere, effort.frontCells));
  measure(runs, effort);

  nlohmann::json all;
  all["threads"] = Kokkos::DefaultExecutionSpace().concurrency();
  for (int levels = 1; levels <= effort.levels; ++levels)
  {
    const TimedRun& small = runs[2 * levels - 2];
    const TimedRun& everywhere = runs[2 * levels - 1];
    nlohmann::json entry;
    entry["maximum_level"] = levels;
    entry["short_in_small_cells"] = timesOf(small, effort.interval);
    entry["short_everywhere"] = timesOf(everywhere, effort.interval);
    entry["times_faster"] = leastSeconds(everywhere) / leastSeconds(small);
    entry["times_fewer_particle_steps"] =
        everywhere.batches.back().particleSteps / small.batches.back().particleSteps;
    all["levels"].push_back(entry);
  }
  return all;
}

} // namespace Rhegma::benchmarks
