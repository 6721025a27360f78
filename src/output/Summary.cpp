#include "output/Summary.hpp"

#include "files/TextFile.hpp"

#include <sys/resource.h>

#include <cmath>
#include <numeric>

namespace Rhegma
{

double peakMemoryBytes()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
#ifdef __APPLE__
  return static_cast<double>(usage.ru_maxrss);
#else
  return 1024.0 * static_cast<double>(usage.ru_maxrss); // Linux counts in KiB
#endif
}

nlohmann::json makeSummary(const SummaryFacts& facts, const nlohmann::json& report)
{
  nlohmann::json summary;
  summary["scene"] = facts.scene;
  summary["version"] = RHEGMA_VERSION;
  summary["backend"] = facts.backend;
  summary["ranks"] = facts.ranks;
  summary["threads"] = facts.threads;
  summary["effects"] = facts.effects;
  summary["steps"] = facts.steps;
  summary["time"] = facts.time;
  summary["wall_seconds"] = facts.wallSeconds;
  summary["particles"] = facts.particles;
  summary["particle_steps"] = facts.particleSteps;
  // A run without a step has no cost per step.
  summary["ns_per_particle_step"] = facts.particleSteps > 0.0
                                        ? nlohmann::json(1.0e9 * facts.wallSeconds / facts.particleSteps)
                                        : nlohmann::json();
  const double memory = std::accumulate(facts.peakMemory.begin(), facts.peakMemory.end(), 0.0);
  summary["peak_memory_bytes"] = static_cast<long long>(memory);
  summary["peak_memory_bytes_of_ranks"] = nlohmann::json::array();
  for (const double bytes : facts.peakMemory)
    summary["peak_memory_bytes_of_ranks"].push_back(static_cast<long long>(bytes));
  summary["bytes_per_particle"] =
      facts.particles > 0 ? nlohmann::json(std::round(memory / facts.particles)) : nlohmann::json();
  summary["stages"] = facts.stages;
  summary["cracks"] = nlohmann::json::array();
  summary["settled"] = facts.settled;
  summary["references"] = nlohmann::json::array();
  if (report.is_object())
    summary.update(report);
  return summary;
}

void writeSummary(const nlohmann::json& summary, const std::string& path)
{
  nlohmann::ordered_json ordered;
  for (const char* first : {"status", "answers", "warnings"})
    if (summary.contains(first))
      ordered[first] = summary[first];
  for (const auto& entry : summary.items())
    ordered[entry.key()] = entry.value();
  // A path need not be UTF-8; JSON must be.
  replaceFile(path, ordered.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

} // namespace Rhegma
