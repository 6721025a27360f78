/// Cost of crack growth compared with the same run with a held crack, alternating in one process.
///
///     growth SCENE.xml [--json] [--cell EDGE] [--steps N] [--rounds N] [--warm-up N]
///
/// Threads: OMP_NUM_THREADS.

#include "common/CommandLine.hpp"
#include "common/Program.hpp"
#include "growth/Measure.hpp"

#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

namespace
{

using namespace Rhegma::benchmarks;

void printTable(const nlohmann::json& all)
{
  std::cout << all.at("particles") << " particles, " << all.at("threads") << " threads, "
            << all.at("increments") << " increments\n"
            << "                         us/step held    of it    of a step    of processor time\n"
            << std::fixed;
  for (const nlohmann::json& entry : all.at("runs"))
    std::cout << "  " << std::left << std::setw(24) << entry.at("name").get<std::string>() << std::right
              << std::setprecision(0) << std::setw(11) << entry.at("us").get<double>() << std::setprecision(2)
              << std::setw(9) << entry.at("ratio").get<double>() << std::setw(13)
              << entry.at("ratio_of_steps").get<double>() << std::setw(21)
              << entry.at("ratio_of_processor").get<double>() << "\n";
}

void run(const std::vector<std::string>& arguments)
{
  GrowthEffort effort;
  std::string scene;
  bool json = false;
  CommandLine()
      .flag("--json", json)
      .number("--cell", effort.cell)
      .number("--steps", effort.steps)
      .number("--rounds", effort.rounds)
      .number("--warm-up", effort.warmUp)
      .scene(scene, "xml_inputs/examples/strip_running.xml")
      .read(arguments);
  placeThreads();
  print(withKokkos([&] { return measureGrowth(scene, effort); }), json, printTable);
}

} // namespace

int main(int argc, char** argv)
{
  return statusOf("growth", [&] { run({argv, argv + argc}); });
}
