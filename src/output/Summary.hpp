#pragma once
/// summary.json: scene, cost and results of a run.

#include "output/References.hpp"

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace Rhegma
{

/// Facts on a run when it ends.
struct SummaryFacts
{
  std::string scene; ///< path as the user gave it
  std::string backend;
  int ranks = 1;
  int threads = 1;
  std::vector<std::string> effects;
  long steps = 0;
  double time = 0.0;        ///< reached by the run [s]
  double wallSeconds = 0.0; ///< [s]
  int particles = 0;
  double particleSteps = 0.0;           ///< particles moved, added up over the steps
  std::map<std::string, double> stages; ///< name -> seconds
  std::vector<double> peakMemory;       ///< of each rank [bytes]
  bool settled = false;
};

/// The summary, with an empty list of cracks and no references unless the report brings them.
/// \param report energies, momentum and what effects add; its keys win
nlohmann::json makeSummary(const SummaryFacts& facts, const nlohmann::json& report);

/// Writes the summary atomically, the answer of the run first (status, answers, warnings). Throws OutputError
/// on failure.
void writeSummary(const nlohmann::json& summary, const std::string& path);

/// Largest memory that the process has held so far [bytes].
double peakMemoryBytes();

} // namespace Rhegma
