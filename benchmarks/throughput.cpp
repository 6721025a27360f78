/// Nanoseconds per particle and step of the program's own step, beside the memory bandwidth of the machine.
///
///     throughput [--json] [--particles N] [--steps N] [--rounds N] [--triad N] [--threads N]
///
/// Measures with 1 and 2 threads where the back end has threads, or with --threads N only.

#include "PositiveNumber.hpp"
#include "throughput/Cases.hpp"
#include "throughput/Measure.hpp"
#include "throughput/Worker.hpp"

#include <Kokkos_Core.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <stdexcept>

namespace
{

using namespace Rhegma::benchmarks;

struct Options
{
  Effort effort;
  bool json = false;
  bool worker = false; ///< measure in this process
  int threads = 0;     ///< 0: 1 and 2
};

Options readOptions(const std::vector<std::string>& arguments)
{
  Options options;
  for (std::size_t k = 1; k < arguments.size(); ++k)
  {
    const std::string& name = arguments[k];
    if (name == "--json" || name == "--worker")
    {
      (name == "--json" ? options.json : options.worker) = true;
      continue;
    }
    const std::string text = k + 1 < arguments.size() ? arguments[k + 1] : "";
    ++k;
    if (name == "--particles")
      options.effort.particles2 = options.effort.particles3 = positiveNumber<int>(name, text);
    else if (name == "--steps")
      options.effort.steps = positiveNumber<int>(name, text);
    else if (name == "--rounds")
      options.effort.rounds = positiveNumber<int>(name, text);
    else if (name == "--triad")
      options.effort.triad = positiveNumber<int>(name, text);
    else if (name == "--threads")
      options.threads = positiveNumber<int>(name, text);
    else
      throw std::invalid_argument(
          "\"" + name +
          "\" is not an option; there are --json, --particles N, --steps N, --rounds N, "
          "--triad N and --threads N");
  }
  return options;
}

/// The results of one process for each number of threads, in the form of --json.
nlohmann::json gather(const Options& options, std::vector<std::string> arguments)
{
  arguments.emplace_back("--worker");
  std::vector<int> counts{1, 2};
  if (options.threads > 0)
    counts = {options.threads};
#ifndef KOKKOS_ENABLE_OPENMP
  counts = {1};
#endif
  nlohmann::json all;
  all["bandwidth_GBs"] = nlohmann::json::object();
  all["cases"] = nlohmann::json::array();
  for (const int threads : counts)
  {
    const nlohmann::json one = nlohmann::json::parse(runAgain(arguments, threads));
    all["bandwidth_GBs"][std::to_string(one.at("threads").get<int>())] = one.at("bandwidth_GBs");
    for (const nlohmann::json& entry : one.at("cases"))
      all["cases"].push_back(entry);
  }
  return all;
}

const nlohmann::json* find(const nlohmann::json& cases, const std::string& name, int threads)
{
  const auto found = std::find_if(cases.begin(), cases.end(),
                                  [&](const nlohmann::json& entry)
                                  { return entry.at("name") == name && entry.at("threads") == threads; });
  return found == cases.end() ? nullptr : &*found;
}

void printTable(const nlohmann::json& all)
{
  const nlohmann::json& cases = all.at("cases");
  for (const auto& [threads, bandwidth] : all.at("bandwidth_GBs").items())
  {
    std::cout
        << threads << (threads == "1" ? " thread" : " threads") << ", triad " << std::fixed
        << std::setprecision(1) << bandwidth.get<double>() << " GB/s\n"
        << "  case                       particles   ns/particle/step   bound ns   ratio   allowed on 2\n";
    for (const Case& which : allCases())
    {
      const nlohmann::json* entry = find(cases, which.name, std::stoi(threads));
      if (entry == nullptr)
        continue;
      const double time = entry->at("ns_per_particle_step").get<double>();
      const double bound = which.boundBytes / bandwidth.get<double>();
      std::cout << "  " << std::left << std::setw(26) << which.name << std::right << std::setw(10)
                << entry->at("particles").get<int>() << std::setw(19) << time << std::setw(11) << bound
                << std::setw(8) << time / bound << std::setw(15) << which.allowed << "\n";
      if (const nlohmann::json* other = find(cases, which.compareTo, std::stoi(threads)))
        std::cout << "  " << std::setw(74) << "that is " << std::setprecision(3)
                  << time / other->at("ns_per_particle_step").get<double>() << " of " << which.compareTo
                  << std::setprecision(1) << "\n";
    }
  }
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    const std::vector<std::string> arguments(argv, argv + argc);
    const Options options = readOptions(arguments);
    if (options.worker)
    {
      Kokkos::initialize();
      std::cout << measure(options.effort) << "\n";
      Kokkos::finalize();
      return 0;
    }
    const nlohmann::json all = gather(options, arguments);
    if (options.json)
      std::cout << all.dump(2) << "\n";
    else
      printTable(all);
  }
  catch (const std::exception& error)
  {
    std::cerr << "throughput: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
