/// What a step costs with each mass matrix, next to the lumped one, in one process and turn by turn.
///
///     mass_matrix SCENE.xml [--json] [--steps N] [--rounds N] [--warm-up N]
///
/// Threads: OMP_NUM_THREADS.

#include "common/InTurns.hpp"
#include "mass_matrix/Measure.hpp"

#include <iomanip>
#include <iostream>
#include <string>

namespace
{

using namespace Rhegma::benchmarks;

void printTable(const nlohmann::json& all)
{
  std::cout << all.at("particles") << " particles, " << all.at("threads") << " threads\n"
            << "  mass matrix       us/step   of lumped   iterations/solve\n"
            << std::fixed;
  for (const nlohmann::json& entry : all.at("matrices"))
  {
    std::cout << "  " << std::left << std::setw(14) << entry.at("name").get<std::string>() << std::right
              << std::setprecision(0) << std::setw(11) << entry.at("us_per_step").get<double>()
              << std::setprecision(2) << std::setw(12) << entry.at("of_lumped").get<double>();
    if (entry.contains("cg_iterations_mean"))
      std::cout << std::setprecision(1) << std::setw(19) << entry.at("cg_iterations_mean").get<double>();
    std::cout << "\n";
  }
}

} // namespace

int main(int argc, char** argv)
{
  return statusOf("mass_matrix",
                  [&]
                  {
                    runInTurns<MassMatrixEffort>({argv, argv + argc}, "xml_inputs/verification/dcb_h16.xml",
                                                 measureMassMatrices, printTable);
                  });
}
