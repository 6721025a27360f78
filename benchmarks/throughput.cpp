/// Nanoseconds per particle and step of the program's own step, next to the memory bandwidth of the machine.
///
///     throughput [--json] [--particles N] [--flow N] [--steps N] [--rounds N] [--triad N] [--threads N]
///
/// With --flow bodies fly and turn fast for N steps before they are timed, so that their particles lie
/// anywhere in their cells. Measures with 1 and 2 threads where the back end has threads, or with --threads N
/// only.

#include "common/CommandLine.hpp"
#include "common/Program.hpp"
#include "throughput/Cases.hpp"
#include "throughput/Measure.hpp"
#include "throughput/Worker.hpp"

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

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

Options readOptions(std::vector<std::string> arguments)
{
  Options options;
  const auto worker = std::find(arguments.begin(), arguments.end(), "--worker");
  options.worker = worker != arguments.end();
  if (options.worker)
    arguments.erase(worker);
  int particles = 0;
  CommandLine()
      .flag("--json", options.json)
      .number("--particles", particles)
      .number("--flow", options.effort.flow)
      .number("--steps", options.effort.steps)
      .number("--rounds", options.effort.rounds)
      .number("--triad", options.effort.triad)
      .number("--threads", options.threads)
      .read(arguments);
  if (particles > 0)
    options.effort.particles2 = options.effort.particles3 = particles;
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

void run(const std::vector<std::string>& arguments)
{
  const Options options = readOptions(arguments);
  if (options.worker)
    std::cout << withKokkos([&] { return measure(options.effort); }) << "\n";
  else
    print(gather(options, arguments), options.json, printTable);
}

} // namespace

int main(int argc, char** argv)
{
  return statusOf("throughput", [&] { run({argv, argv + argc}); });
}
