/// What burning costs next to the same cracks without it, in one process and turn by turn.
///
///     combustion SCENE.xml [--json] [--steps N] [--rounds N] [--warm-up N]
///
/// Threads: OMP_NUM_THREADS.

#include "combustion/Measure.hpp"
#include "common/InTurns.hpp"

#include <iomanip>
#include <iostream>
#include <string>

namespace
{

using namespace Rhegma::benchmarks;

void printTable(const nlohmann::json& all)
{
  std::cout << all.at("particles") << " particles, " << all.at("threads") << " threads\n"
            << "                        us/step without    of it    of a step    of processor time\n"
            << std::fixed;
  for (const nlohmann::json& entry : all.at("runs"))
    std::cout << "  " << std::left << std::setw(22) << entry.at("name").get<std::string>() << std::right
              << std::setprecision(0) << std::setw(15) << entry.at("us").get<double>() << std::setprecision(2)
              << std::setw(9) << entry.at("ratio").get<double>() << std::setw(13)
              << entry.at("ratio_of_steps").get<double>() << std::setw(21)
              << entry.at("ratio_of_processor").get<double>() << "\n";
}

} // namespace

int main(int argc, char** argv)
{
  return statusOf("combustion",
                  [&]
                  {
                    runInTurns<CombustionEffort>({argv, argv + argc}, "xml_inputs/examples/burning_crack.xml",
                                                 measureCombustion, printTable);
                  });
}
