#include "base/MemoryNeed.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

namespace Rhegma
{

namespace
{

constexpr double unknown = std::numeric_limits<double>::infinity();

/// The number after a name in a file of pairs; without a name the number that the file holds. None if the
/// file or the name is not there, or no number follows ("max").
std::optional<double> numberIn(const std::string& file, const std::string& name = "")
{
  std::ifstream in(file);
  double value = 0.0;
  if (name.empty())
    return in >> value ? std::optional<double>(value) : std::nullopt;
  for (std::string found; in >> found; in.ignore(std::numeric_limits<std::streamsize>::max(), '\n'))
    if (found == name)
      return in >> value ? std::optional<double>(value) : std::nullopt;
  return {};
}

/// Memory that a control group leaves, not counting file caches that can be dropped.
double freeInGroup(const std::string& limit, const std::string& usage, const std::string& statistics,
                   const std::string& cached)
{
  const auto most = numberIn(limit);
  const auto used = numberIn(usage);
  if (!most || !used)
    return unknown;
  return std::max(*most - *used + numberIn(statistics, cached).value_or(0.0), 0.0);
}

std::string asText(double bytes)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.3g GB", 1e-9 * bytes);
  return text;
}

} // namespace

double freeMemoryBytes()
{
  // MemAvailable counts what the system can take back from its caches.
  const auto kibibytes = numberIn("/proc/meminfo", "MemAvailable:");
  const double onMachine = kibibytes ? 1024.0 * *kibibytes : unknown;
  const std::string two = "/sys/fs/cgroup/", one = "/sys/fs/cgroup/memory/"; // versions of control groups
  return std::min(
      {onMachine,
       freeInGroup(two + "memory.max", two + "memory.current", two + "memory.stat", "inactive_file"),
       freeInGroup(one + "memory.limit_in_bytes", one + "memory.usage_in_bytes", one + "memory.stat",
                   "total_inactive_file")});
}

void refuseWithoutMemory(double nodes, double bytesPerNode, double particles, double bytesPerParticle,
                         double available)
{
  const double needed = nodes * bytesPerNode + particles * bytesPerParticle;
  if (!(needed > available))
    return;
  char count[96];
  std::snprintf(count, sizeof count, "%.3g particles and %.3g nodes", particles, nodes);
  throw std::invalid_argument("Domain > Cell Size: the scene would have about " + std::string(count) +
                              ", which need " + asText(needed) + " of memory where " + asText(available) +
                              " are free; use larger cells or a smaller domain");
}

} // namespace Rhegma
