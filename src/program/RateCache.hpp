#pragma once
/// Measured rates of scenes, kept for the next time.

#include "program/StepRates.hpp"

#include <optional>
#include <string>

namespace Rhegma::program
{

/// What rates hold for: host, processor and its cores, back end, threads and ranks.
std::string machineIdentity(int ranks);

/// The build of the running program, whose speed depends on compiler and flags: version, size of its file and
/// when that was written.
std::string buildIdentity();

/// The folder ${XDG_CACHE_HOME:-~/.cache}/rhegma; empty where neither variable is set.
std::string cacheFolder();

/// A file of rates in a folder, of one machine identity. What is of another one, damaged or of another format
/// is not used and replaced by what is measured next. Rates of several builds are kept next to each other.
/// Nothing fails where the folder can't be read or written. Several processes may use a file at the same
/// time: it is always complete, and one that they write at once holds the rates of one of them.
class RateCache
{
public:
  /// \param machine machineIdentity \param build buildIdentity: rates of another one are not found
  RateCache(std::string folder, std::string machine, std::string build);

  /// The rates of a scene. \param scene validated
  std::optional<StepRates> find(const Teuchos::ParameterList& scene) const;
  /// Keeps them, next to those of the scenes that were kept last.
  void keep(const Teuchos::ParameterList& scene, const StepRates& rates) const;

  const std::string& path() const { return path_; }

private:
  /// Of a scene, with this build.
  std::string keyOf(const Teuchos::ParameterList& scene) const;

  std::string path_, machine_, build_;
};

} // namespace Rhegma::program
