/// What a scene costs whose cells refine, beside the same scene with small cells everywhere, in one process
/// and turn by turn.
///
///     adaptive SCENE.xml [--json] [--rounds N] [--finer N] [--interval SECONDS]
///
/// Threads: OMP_NUM_THREADS.

#include "PositiveNumber.hpp"
#include "adaptive/Measure.hpp"

#include <Kokkos_Core.hpp>

#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <stdexcept>
#include <vector>

namespace
{

using namespace Rhegma::benchmarks;

struct Options
{
  AdaptiveEffort effort;
  std::string scene;
  bool json = false;
};

Options readOptions(const std::vector<std::string>& arguments)
{
  Options options;
  for (std::size_t k = 1; k < arguments.size(); ++k)
  {
    const std::string& name = arguments[k];
    const auto next = [&] { return ++k < arguments.size() ? arguments[k] : std::string(); };
    if (name == "--json")
      options.json = true;
    else if (name == "--rounds")
      options.effort.rounds = positiveNumber<int>(name, next());
    else if (name == "--finer")
      options.effort.finer = positiveNumber<int>(name, next());
    else if (name == "--interval")
      options.effort.interval = positiveNumber<double>(name, next());
    else if (name.rfind("--", 0) != 0 && options.scene.empty())
      options.scene = name;
    else
      throw std::invalid_argument("\"" + name +
                                  "\" is not an option; write SCENE.xml [--json] [--rounds N] [--finer N] "
                                  "[--interval SECONDS]");
  }
  if (options.scene.empty())
    throw std::invalid_argument("write the scene that shall be timed, as "
                                "xml_inputs/verification/dcb_adaptive.xml");
  return options;
}

void printTable(const nlohmann::json& all)
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

} // namespace

int main(int argc, char** argv)
{
  try
  {
    const Options options = readOptions(std::vector<std::string>(argv, argv + argc));
    // As the program itself does where the user has not decided.
    setenv("OMP_PROC_BIND", "spread", 0);
    setenv("OMP_PLACES", "threads", 0);
    Kokkos::ScopeGuard kokkos(argc, argv);
    const nlohmann::json all = measureAdaptive(options.scene, options.effort);
    if (options.json)
      std::cout << all.dump(2) << "\n";
    else
      printTable(all);
  }
  catch (const std::exception& error)
  {
    std::cerr << "adaptive: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
