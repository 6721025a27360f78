/// What heat costs next to the same motion without it, or, for a scene of heat alone, what each method of
/// conduction costs, in one process and turn by turn.
///
///     heat SCENE.xml [--json] [--cell EDGE] [--steps N] [--rounds N] [--warm-up N]
///
/// Threads: OMP_NUM_THREADS.

#include "common/InTurns.hpp"
#include "heat/Measure.hpp"

#include <iomanip>
#include <iostream>
#include <string>

namespace
{

using namespace Rhegma::benchmarks;

void printTable(const nlohmann::json& all)
{
  std::cout << all.at("particles") << " particles, " << all.at("threads") << " threads\n"
            << (all.at("heat_alone").get<bool>() ? "  conduction           us/explicit step   of it\n"
                                                 : "                       us/step            of it\n")
            << std::fixed;
  for (const nlohmann::json& entry : all.at("runs"))
    std::cout << "  " << std::left << std::setw(20) << entry.at("name").get<std::string>() << std::right
              << std::setprecision(0) << std::setw(14) << entry.at("us").get<double>() << std::setprecision(2)
              << std::setw(12) << entry.at("ratio").get<double>() << "\n";
}

} // namespace

int main(int argc, char** argv)
{
  return statusOf("heat",
                  [&]
                  {
                    runInTurns<HeatEffort>(
                        {argv, argv + argc}, "xml_inputs/verification/thermoelastic_rise.xml", measureHeat,
                        printTable,
                        [](CommandLine& line, HeatEffort& effort) { line.number("--cell", effort.cell); });
                  });
}
