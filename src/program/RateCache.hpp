#pragma once
/// Measured rates of scenes, kept for the next time.

#include "program/StepRates.hpp"

#include <optional>
#include <string>

namespace Rhegma::program
{

/// What rates hold for: host, processor and its cores, back end, threads, ranks and version of the program.
std::string machineIdentity(int ranks);

/// The folder ${XDG_CACHE_HOME:-~/.cache}/rhegma; empty where neither variable is set.
std::string cacheFolder();

/// A file of rates in a folder, of one machine identity. What is of another one, damaged or of another format
/// is not used and replaced by what is measured next. Nothing fails where the folder can't be read or
/// written.
class RateCache
{
public:
  RateCache(std::string folder, std::string identity);

  /// The rates of a scene. \param scene validated
  std::optional<StepRates> find(const Teuchos::ParameterList& scene) const;
  /// Keeps them, next to those of the scenes that were kept last.
  void keep(const Teuchos::ParameterList& scene, const StepRates& rates) const;

  const std::string& path() const { return path_; }

private:
  std::string path_, identity_;
};

} // namespace Rhegma::program
