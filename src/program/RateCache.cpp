#include "program/RateCache.hpp"

#include "base/OutputError.hpp"
#include "files/TextFile.hpp"

#include <Kokkos_Core.hpp>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>
#include <utility>

namespace Rhegma::program
{

namespace
{

/// Scenes that a file keeps.
constexpr std::size_t mostScenes = 100;

struct Entry
{
  const char* name;
  double StepRates::*value;
};

constexpr std::array<Entry, 15> entries{{{"setup", &StepRates::setup},
                                         {"spent", &StepRates::spent},
                                         {"solves", &StepRates::solves},
                                         {"solve", &StepRates::solve},
                                         {"increment_solves", &StepRates::incrementSolves},
                                         {"step", &StepRates::step},
                                         {"sample", &StepRates::sample},
                                         {"frame", &StepRates::frame},
                                         {"frame_bytes", &StepRates::frameBytes},
                                         {"checkpoint", &StepRates::checkpoint},
                                         {"checkpoint_bytes", &StepRates::checkpointBytes},
                                         {"memory", &StepRates::memory},
                                         {"time_step", &StepRates::timeStep},
                                         {"time", &StepRates::time},
                                         {"busy", &StepRates::busy}}};

std::string processorName()
{
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.rfind("model name", 0) == 0 && line.find(':') != std::string::npos)
      return line.substr(line.find(':') + 1);
  return {};
}

/// FNV-1a, as 16 digits.
std::string hashOf(const std::string& text)
{
  unsigned long long hash = 14695981039346656037ULL;
  for (const unsigned char letter : text)
    hash = (hash ^ letter) * 1099511628211ULL;
  char digits[24];
  std::snprintf(digits, sizeof digits, "%016llx", hash);
  return digits;
}

nlohmann::json readJson(const std::string& path)
{
  std::ifstream file(path);
  return nlohmann::json::parse(file, nullptr, false);
}

} // namespace

std::string machineIdentity(int ranks)
{
  char host[256] = {};
  gethostname(host, sizeof host - 1);
  std::ostringstream text;
  text << host << ";" << processorName() << "; " << std::thread::hardware_concurrency() << " cores; "
       << Kokkos::DefaultExecutionSpace::name() << "; " << Kokkos::DefaultExecutionSpace().concurrency()
       << " threads; " << ranks << " ranks";
  return text.str();
}

std::string buildIdentity()
{
  std::ostringstream text;
  text << "rhegma " << RHEGMA_VERSION;
  struct stat file = {};
  if (stat("/proc/self/exe", &file) == 0) // of the file that runs, also where it has been replaced since
    text << "; " << file.st_size << " bytes of " << file.st_mtim.tv_sec << "." << file.st_mtim.tv_nsec;
  return text.str();
}

std::string cacheFolder()
{
  const char* cache = std::getenv("XDG_CACHE_HOME");
  if (cache != nullptr && cache[0] == '/') // a relative one is to be ignored (XDG Base Directory)
    return std::string(cache) + "/rhegma";
  const char* home = std::getenv("HOME");
  return home != nullptr && home[0] == '/' ? std::string(home) + "/.cache/rhegma" : std::string();
}

RateCache::RateCache(std::string folder, std::string machine, std::string build)
    : path_(folder.empty() ? folder : std::move(folder) + "/rates-" + hashOf(machine) + ".json"),
      machine_(std::move(machine)),
      build_(std::move(build))
{
}

/// All parameters with their values; what is only about the output of a run counts too.
std::string RateCache::keyOf(const Teuchos::ParameterList& scene) const
{
  std::ostringstream text;
  text.precision(17);
  scene.print(text, Teuchos::ParameterList::PrintOptions().showTypes(true).showFlags(false));
  return hashOf(build_ + "\n" + text.str());
}

std::optional<StepRates> RateCache::find(const Teuchos::ParameterList& scene) const
try
{
  if (path_.empty())
    return {};
  const nlohmann::json file = readJson(path_);
  if (!file.is_object() || file.value("machine", "") != machine_)
    return {};
  const nlohmann::json& scenes = file.at("scenes");
  const std::string key = keyOf(scene);
  for (const auto& kept : scenes)
    if (kept.at("scene") == key)
    {
      StepRates rates;
      for (const Entry& entry : entries)
        rates.*entry.value = kept.at(entry.name).get<double>();
      rates.particles = kept.at("particles").get<int>();
      rates.steps = kept.at("steps").get<int>();
      rates.unknowns = kept.at("unknowns").get<int>();
      rates.measured = kept.at("measured").get<long long>();
      rates.growth = {kept.at("growth_of_steps").get<double>(), kept.at("growth_of_work").get<double>()};
      return rates;
    }
  return {};
}
catch (const nlohmann::json::exception&)
{
  return {};
}

void RateCache::keep(const Teuchos::ParameterList& scene, const StepRates& rates) const
try
{
  if (path_.empty() || !rates.failure.empty())
    return;
  const std::string key = keyOf(scene);
  nlohmann::json fresh = {{"scene", key},
                          {"particles", rates.particles},
                          {"steps", rates.steps},
                          {"unknowns", rates.unknowns},
                          {"measured", rates.measured},
                          {"growth_of_steps", rates.growth.steps},
                          {"growth_of_work", rates.growth.work}};
  for (const Entry& entry : entries)
    fresh[entry.name] = rates.*entry.value;
  nlohmann::json scenes = nlohmann::json::array({fresh});
  const nlohmann::json before = readJson(path_);
  if (before.is_object() && before.value("machine", "") == machine_)
    for (const auto& kept : before.value("scenes", nlohmann::json::array()))
      if (kept.is_object() && kept.value("scene", "") != key && scenes.size() < mostScenes)
        scenes.push_back(kept);
  std::error_code none;
  std::filesystem::create_directories(std::filesystem::path(path_).parent_path(), none);
  replaceSharedFile(path_, nlohmann::json({{"machine", machine_}, {"scenes", scenes}})
                                   .dump(1, ' ', false, nlohmann::json::error_handler_t::replace) +
                               "\n");
}
catch (const OutputError&)
{
}
catch (const nlohmann::json::exception&)
{
}

} // namespace Rhegma::program
