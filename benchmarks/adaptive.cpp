/// Cost of a scene with adaptive cells, compared with the same scene with small cells everywhere, or with
/// small steps everywhere, alternating in one process.
///
///     adaptive SCENE.xml [--json] [--rounds N] [--interval SECONDS] [--finer N]
///     adaptive SCENE.xml --levels N [--front-cells N] [--json] [--rounds N] [--interval SECONDS]
///
/// The second times, for Adaptivity > Maximum Level = 1 ... N, substeps in small cells only (Sub-Cycling)
/// next to substeps in all cells. Threads: OMP_NUM_THREADS.

#include "adaptive/Measure.hpp"
#include "common/CommandLine.hpp"
#include "common/Program.hpp"

#include <iomanip>
#include <iostream>
#include <vector>

namespace
{

using namespace Rhegma::benchmarks;

void printRuns(const nlohmann::json& all)
{
  std::cout << all.at("threads") << " threads\n"
            << "  run                    particles   us/step   seconds/simulated ms   of adaptive\n"
            << std::fixed;
  for (const nlohmann::json& entry : all.at("runs"))
    std::cout << "  " << std::left << std::setw(22) << entry.at("name").get<std::string>() << std::right
              << std::setw(10) << entry.at("particles").get<int>() << std::setprecision(0) << std::setw(10)
              << entry.at("us_per_step").get<double>() << std::setprecision(3) << std::setw(23)
              << entry.at("seconds_per_simulated_ms").get<double>() << std::setprecision(2) << std::setw(14)
              << entry.at("of_adaptive").get<double>() << "\n";
}

void printLevels(const nlohmann::json& all)
{
  std::cout << all.at("threads") << " threads\n"
            << "                      seconds/simulated ms, small steps   small steps in small cells only:\n"
            << "  levels   particles   in small cells      everywhere   times faster   fewer particle-steps\n"
            << std::fixed;
  for (const nlohmann::json& entry : all.at("levels"))
  {
    const nlohmann::json& small = entry.at("short_in_small_cells");
    std::cout << std::setw(8) << entry.at("maximum_level").get<int>() << std::setw(12)
              << small.at("particles").get<int>() << std::setprecision(3) << std::setw(17)
              << small.at("seconds_per_simulated_ms").get<double>() << std::setw(16)
              << entry.at("short_everywhere").at("seconds_per_simulated_ms").get<double>()
              << std::setprecision(2) << std::setw(15) << entry.at("times_faster").get<double>()
              << std::setw(23) << entry.at("times_fewer_particle_steps").get<double>() << "\n";
  }
}

void run(const std::vector<std::string>& arguments)
{
  AdaptiveEffort effort;
  std::string scene;
  bool json = false;
  CommandLine()
      .flag("--json", json)
      .number("--rounds", effort.rounds)
      .number("--finer", effort.finer)
      .number("--levels", effort.levels)
      .number("--front-cells", effort.frontCells)
      .number("--interval", effort.interval)
      .scene(scene, "xml_inputs/verification/dcb_adaptive.xml")
      .read(arguments);
  placeThreads();
  if (effort.levels > 0)
    print(withKokkos([&] { return measureSmallSteps(scene, effort); }), json, printLevels);
  else
    print(withKokkos([&] { return measureAdaptive(scene, effort); }), json, printRuns);
}

} // namespace

int main(int argc, char** argv)
{
  return statusOf("adaptive", [&] { run({argv, argv + argc}); });
}
