#include "program/CheckedState.hpp"

#include "base/OutputError.hpp"
#include "output/OutputFolder.hpp"
#include "output/Summary.hpp"
#include "parallel/FirstRank.hpp"

#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <vector>

namespace Rhegma::program
{

namespace
{

std::vector<std::string> linesOf(const std::string& text)
{
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    lines.push_back(line);
  return lines;
}

/// Makes a folder, which must not hold the results of a run: they would be replaced.
void takeEmptyFolder(const std::string& folder)
{
  std::error_code error;
  if (std::filesystem::exists(folder, error) && !std::filesystem::is_empty(folder, error))
    throw std::invalid_argument("--state: " + folder + " is no empty folder; write the name of a new one");
  makeOutputFolder(folder);
}

} // namespace

void writeCheckedState(const std::string& folder, Simulation& simulation, nlohmann::json summary,
                       const std::string& loads, const Ranks& ranks)
{
  onFirstRank<std::invalid_argument>(ranks, [&] { takeEmptyFolder(folder); });
  simulation.writeFields(folder);
  summary["loads"] = linesOf(loads);
  onFirstRank<OutputError>(ranks, [&] { writeSummary(summary, folder + "/check.json"); });
}

} // namespace Rhegma::program
