/// What a step costs with each mass matrix, beside the lumped one, in one process and turn by turn.
///
///     mass_matrix SCENE.xml [--json] [--steps N] [--rounds N] [--warm-up N]
///
/// Threads: OMP_NUM_THREADS.

#include "PositiveNumber.hpp"
#include "mass_matrix/Measure.hpp"

#include <Kokkos_Core.hpp>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

using namespace Rhegma::benchmarks;

struct Options
{
  MassMatrixEffort effort;
  std::string scene;
  bool json = false;
};

Options readOptions(const std::vector<std::string>& arguments)
{
  Options options;
  for (std::size_t k = 1; k < arguments.size(); ++k)
  {
    const std::string& name = arguments[k];
    const auto number = [&] { return positiveNumber<int>(name, ++k < arguments.size() ? arguments[k] : ""); };
    if (name == "--json")
      options.json = true;
    else if (name == "--steps")
      options.effort.steps = number();
    else if (name == "--rounds")
      options.effort.rounds = number();
    else if (name == "--warm-up")
      options.effort.warmUp = number();
    else if (name.rfind("--", 0) != 0 && options.scene.empty())
      options.scene = name;
    else
      throw std::invalid_argument("\"" + name +
                                  "\" is not an option; write SCENE.xml [--json] [--steps N] [--rounds N] "
                                  "[--warm-up N]");
  }
  if (options.scene.empty())
    throw std::invalid_argument("write the scene whose steps shall be timed, as "
                                "xml_inputs/verification/dcb_h16.xml");
  return options;
}

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
  int status = 0;
  try
  {
    const Options options = readOptions({argv, argv + argc});
    // As the program itself does where the user has not decided.
    setenv("OMP_PROC_BIND", "spread", 0);
    setenv("OMP_PLACES", "threads", 0);
    Kokkos::initialize();
    try
    {
      const nlohmann::json all = measureMassMatrices(options.scene, options.effort);
      if (options.json)
        std::cout << all.dump(2) << "\n";
      else
        printTable(all);
    }
    catch (...)
    {
      Kokkos::finalize();
      throw;
    }
    Kokkos::finalize();
  }
  catch (const std::exception& error)
  {
    std::cerr << "mass_matrix: " << error.what() << "\n";
    status = 1;
  }
  return status;
}
