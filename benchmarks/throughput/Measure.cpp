#include "throughput/Measure.hpp"

#include "common/TimedRun.hpp"
#include "throughput/Cases.hpp"
#include "throughput/Triad.hpp"

#include <Kokkos_Core.hpp>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace Rhegma::benchmarks
{

namespace
{

/// A body that is timed, and what its stages had taken before.
struct Runner
{
  const Case& which;
  TimedRun run;
  std::map<std::string, double> stages;

  Runner(const Case& c, const Effort& effort)
      : which(c),
        run(c.name, makeScene(c, c.dimension == 2 ? effort.particles2 : effort.particles3, effort.flow))
  {
    run.advance(2 + effort.flow); // sorts the particles and touches all memory
    stages = run.simulation->stageSeconds();
  }
};

double nanoseconds(const Batch& batch) { return 1e9 * batch.seconds / batch.particleSteps; }

double median(const std::vector<Batch>& batches)
{
  std::vector<double> values;
  for (const Batch& batch : batches)
    values.push_back(nanoseconds(batch));
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

nlohmann::json result(const Runner& runner, int threads)
{
  nlohmann::json entry;
  entry["name"] = runner.which.name;
  entry["threads"] = threads;
  entry["particles"] = runner.run.simulation->particles();
  entry["ns_per_particle_step"] = runner.run.best(nanoseconds);
  entry["median_ns_per_particle_step"] = median(runner.run.batches);
  entry["bytes_per_particle"] = runner.which.boundBytes;
  // The stages take the same fraction of every step, so the fraction over all batches represents the best
  // one.
  double all = 0.0;
  for (const auto& [stage, seconds] : runner.run.simulation->stageSeconds())
    all += seconds - runner.stages.at(stage);
  for (const auto& [stage, seconds] : runner.run.simulation->stageSeconds())
    entry["stage_fraction"][stage] = (seconds - runner.stages.at(stage)) / all;
  return entry;
}

} // namespace

nlohmann::json measure(const Effort& effort)
{
  const int threads = Kokkos::DefaultExecutionSpace().concurrency();
  Triad triad(effort.triad);
  triad.pass();
  std::vector<Runner> runners;
  runners.reserve(allCases().size());
  for (const Case& which : allCases())
    runners.emplace_back(which, effort);

  double bandwidth = 0.0;
  for (int round = 0; round < effort.rounds; ++round)
    for (Runner& runner : runners)
    {
      bandwidth = std::max(bandwidth, triad.pass());
      runner.run.time(effort.steps);
    }

  nlohmann::json all;
  all["threads"] = threads;
  all["bandwidth_GBs"] = bandwidth;
  all["cases"] = nlohmann::json::array();
  for (const Runner& runner : runners)
    all["cases"].push_back(result(runner, threads));
  return all;
}

} // namespace Rhegma::benchmarks
