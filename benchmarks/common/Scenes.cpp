#include "common/Scenes.hpp"

#include <Kokkos_Core.hpp>
#include <Teuchos_XMLParameterListHelpers.hpp>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace Rhegma::benchmarks
{

Teuchos::RCP<Teuchos::ParameterList> readScene(const std::string& file, const std::string& section,
                                               const std::string& hint)
{
  const auto scene = Teuchos::getParametersFromXmlFile(file);
  if (!scene->isSublist(section))
    throw std::invalid_argument("the scene " + file + " has no section " + section +
                                (hint.empty() ? "" : "; " + hint));
  scene->remove("Reference", false);
  return scene;
}

TimedRun sampledRun(const std::string& name, const Teuchos::RCP<Teuchos::ParameterList>& scene,
                    const Teuchos::RCP<const Teuchos::Comm<int>>& comm)
{
  double samples = 0.0;
  if (scene->isSublist("Output") && scene->sublist("Output").isType<double>("History Interval"))
    samples = scene->sublist("Output").get<double>("History Interval");
  TimedRun run(name, scene, comm);
  if (samples > 0.0)
    run.simulation->sampleEvery(samples, [](double, const Simulation::Row&) {});
  return run;
}

double leastSeconds(const TimedRun& run)
{
  return run.best([](const Batch& batch) { return batch.seconds; });
}

namespace
{

/// Median over the rounds of the ratio within a round: neither a quiet nor a busy moment counts.
double processorRatio(const TimedRun& run, const TimedRun& first)
{
  std::vector<double> ratios;
  for (std::size_t k = 0; k < run.batches.size(); ++k)
  {
    const Batch &mine = run.batches[k], &other = first.batches[k];
    if (other.processorSeconds > 0.0)
      ratios.push_back(mine.processorSeconds / other.processorSeconds * (other.simulated / mine.simulated));
  }
  if (ratios.empty())
    return std::numeric_limits<double>::quiet_NaN();
  const auto middle = ratios.begin() + ratios.size() / 2;
  std::nth_element(ratios.begin(), middle, ratios.end());
  return *middle;
}

} // namespace

nlohmann::json nextToFirst(const std::vector<TimedRun>& runs, int steps)
{
  const TimedRun& first = runs.front();
  const auto perTime = [](const TimedRun& run)
  { return run.best([](const Batch& batch) { return batch.seconds / batch.simulated; }); };
  const double span = first.batches.front().simulated / steps;
  const auto perStep = [](const TimedRun& run)
  { return run.best([](const Batch& batch) { return batch.seconds / batch.steps; }); };
  nlohmann::json all;
  all["particles"] = first.simulation->particles();
  all["threads"] = Kokkos::DefaultExecutionSpace().concurrency();
  for (const TimedRun& run : runs)
    all["runs"].push_back({{"name", run.name},
                           {"us", 1e6 * perTime(run) * span},
                           {"ratio", perTime(run) / perTime(first)},
                           {"ratio_of_steps", perStep(run) / perStep(first)},
                           {"ratio_of_processor", processorRatio(run, first)}});
  return all;
}

} // namespace Rhegma::benchmarks
