#pragma once
/// manifest.json: what a folder holds, with checksums.

#include "output/History.hpp"

#include <nlohmann/json.hpp>
#include <string>

namespace Rhegma
{

/// Length and CRC-32 of a file. \return null where it can't be read
nlohmann::json checksumOf(const std::string& path);

/// Writes manifest.json: what history.csv is up to a row, what the scene was, and at the end of a run all its
/// other text files. It is replaced at once, so that a run that is cut off leaves the last one; only that at
/// the end, and the files that it lists, are synchronised to the disk. Its last line holds the CRC-32 of all
/// before it. `rhegma-check` reads it.
class Manifest
{
public:
  Manifest() = default;
  /// \param scene file of the scene
  Manifest(const std::string& folder, const std::string& scene);

  /// Whether the last one is older than a second.
  bool isDue() const;
  /// \param history what its file holds, no row held back
  /// \param ended   whether all files have been written; then they are synchronised and listed
  /// Throws OutputError when it can't be written.
  void write(const HistorySoFar& history, bool ended = false);

private:
  std::string folder_;
  nlohmann::json scene_;
  double last_ = -1e9; ///< by the clock [s]
};

} // namespace Rhegma
