/// Speed-up of a scene on all ranks compared with one of them, alternating in one run; the messages between
/// ranks; and the expected cost on many ranks.
///
///     mpirun -np 2 ranks SCENE.xml [--json] [--rounds N] [--finer N] [--interval SECONDS]
///                                  [--latency SECONDS] [--bandwidth BYTES_PER_SECOND]
///
/// With more ranks than processors the times say nothing, the messages are what they are. Threads of each
/// rank: OMP_NUM_THREADS.

#include "ranks/Measure.hpp"

#include "common/CommandLine.hpp"
#include "common/Program.hpp"

#include <Teuchos_GlobalMPISession.hpp>

#include <iomanip>
#include <iostream>
#include <vector>

namespace
{

using namespace Rhegma::benchmarks;

void printRanks(const nlohmann::json& all)
{
  std::cout << "  run            particles   us/step\n" << std::fixed << std::setprecision(0);
  for (const nlohmann::json& entry : all.at("runs"))
    std::cout << "  " << std::left << std::setw(14) << entry.at("name").get<std::string>() << std::right
              << std::setw(10) << entry.at("particles").get<int>() << std::setw(10)
              << entry.at("us_per_step").get<double>() << "\n";
  const nlohmann::json& messages = all.at("messages");
  std::cout << std::setprecision(2) << "times faster: " << all.at("times_faster").get<double>() << "\n"
            << std::setprecision(1)
            << "messages per step of the rank that sends most: " << messages.at("sent_per_step").get<double>()
            << " to " << messages.at("receivers").get<double>() << " ranks, "
            << 1e-3 * messages.at("bytes_per_step").get<double>() << " kB; "
            << messages.at("reductions_per_step").get<double>() << " sums over all ranks, "
            << 1e-3 * messages.at("reduced_bytes_per_step").get<double>() << " kB\n"
            << "as much work for each of many ranks (a model):\n"
            << "   ranks   us/step   to neighbours   over all   work fraction\n";
  for (const nlohmann::json& entry : all.at("model"))
    std::cout << std::setw(8) << entry.at("ranks").get<int>() << std::setw(10)
              << entry.at("us_per_step").get<double>() << std::setw(16)
              << entry.at("us_to_neighbours").get<double>() << std::setw(11)
              << entry.at("us_over_all").get<double>() << std::setprecision(3) << std::setw(16)
              << entry.at("work_fraction").get<double>() << std::setprecision(1) << "\n";
}

void run(const std::vector<std::string>& arguments, bool first)
{
  RanksEffort effort;
  std::string scene;
  bool json = false;
  CommandLine()
      .flag("--json", json)
      .number("--rounds", effort.rounds)
      .number("--finer", effort.finer)
      .number("--interval", effort.interval)
      .number("--latency", effort.latency)
      .number("--bandwidth", effort.bandwidth)
      .scene(scene, "xml_inputs/verification/dcb_adaptive_h16.xml")
      .read(arguments);
  const nlohmann::json results = withKokkos([&] { return measureRanks(scene, effort); });
  if (first)
    print(results, json, printRanks);
}

} // namespace

int main(int argc, char** argv)
{
  const Teuchos::GlobalMPISession session(&argc, &argv, nullptr);
  const bool first = Teuchos::GlobalMPISession::getRank() == 0;
  return statusOf("ranks", [&] { run({argv, argv + argc}, first); });
}
