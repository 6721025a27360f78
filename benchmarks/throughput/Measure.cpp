#include "throughput/Measure.hpp"

#include "Simulation.hpp"
#include "throughput/Cases.hpp"
#include "throughput/Triad.hpp"

#include <Kokkos_Core.hpp>
#include <Teuchos_DefaultSerialComm.hpp>

#include <algorithm>
#include <memory>

namespace Rhegma::benchmarks
{

namespace
{

/// A body and the times of its batches.
struct Runner
{
  const Case& which;
  std::unique_ptr<Simulation> simulation;
  std::vector<double> nanoseconds; ///< per particle and step, one a batch
  std::map<std::string, double> stages;

  Runner(const Case& c, const Effort& effort) : which(c)
  {
    simulation =
        std::make_unique<Simulation>(Teuchos::rcp(new Teuchos::SerialComm<int>()),
                                     makeScene(c, c.dimension == 2 ? effort.particles2 : effort.particles3));
    simulation->initialize();
    advance(2); // sorts the particles and touches all memory
    stages = simulation->stageSeconds();
  }

  void advance(int steps) { simulation->advance(simulation->time() + steps * simulation->stableTimeStep()); }

  void batch(int steps)
  {
    const double before = simulation->particleSteps();
    const Kokkos::Timer timer;
    advance(steps);
    nanoseconds.push_back(1e9 * timer.seconds() / (simulation->particleSteps() - before));
  }
};

double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

nlohmann::json result(const Runner& runner, int threads)
{
  nlohmann::json entry;
  entry["name"] = runner.which.name;
  entry["threads"] = threads;
  entry["particles"] = runner.simulation->particles();
  entry["ns_per_particle_step"] = *std::min_element(runner.nanoseconds.begin(), runner.nanoseconds.end());
  entry["median_ns_per_particle_step"] = median(runner.nanoseconds);
  entry["bytes_per_particle"] = runner.which.boundBytes;
  // The stages take the same share of every step, so the share of all batches stands for the best.
  double all = 0.0;
  for (const auto& [stage, seconds] : runner.simulation->stageSeconds())
    all += seconds - runner.stages.at(stage);
  for (const auto& [stage, seconds] : runner.simulation->stageSeconds())
    entry["stage_share"][stage] = (seconds - runner.stages.at(stage)) / all;
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
      runner.batch(effort.steps);
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
