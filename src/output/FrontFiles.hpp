#pragma once
/// fronts.h5 and fronts.csv: values along fronts in 3D over time.

#include "output/History.hpp"
#include "parallel/Ranks.hpp"
#include "state/FrontValues.hpp"

#include <string>
#include <vector>

namespace Rhegma
{

class Archive;

/// Writes the values at the nodes of fronts, sample by sample.
///
/// fronts.h5 has a group a sample, /t00000, /t00001, ..., with attribute `time` [s], and in it a group a
/// front, such as Notch.0:
///
///     s (n) arc length from the start of its line [m]; position (n,3) [m]; G (n) [J/m2];
///     K_I, K_II, K_III (n) [Pa m^0.5]; speed (n) [m/s]; line (n) int, number of the node's line in the front
///
/// n may change from sample to sample. fronts.csv has a row a node and sample: time, crack, front, node, s,
/// x, y, z, G, K_I, K_II, K_III, speed. Both files are made with the first sample that has a front, and are
/// closed after each sample, so that a kill leaves all samples before.
class FrontFiles
{
public:
  /// New files, which replace older ones. \param folder must exist \param ranks of the run, which all have
  /// the same values; the first writes
  explicit FrontFiles(std::string folder, const Ranks& ranks = {});
  /// Continues the files of a run whose checkpoint the archive loads; later samples are removed. Throws
  /// OutputError where they are not those of the run. Collective.
  FrontFiles(std::string folder, Archive& archive);

  /// Adds a sample. Fronts without nodes are left out, and a sample without fronts, or of the time of the one
  /// before. \param time [s] Throws OutputError when it can't be written. Collective.
  void write(double time, const std::vector<FrontValues>& fronts);

  /// Saves how far the files go.
  void serialize(Archive& archive);

  /// Synchronises the files to the disk.
  void sync() const;

private:
  void append(double time, const std::vector<FrontValues>& fronts);
  void appendRows(const std::string& text);

  std::string data_, table_; ///< paths
  Ranks ranks_;
  int written_ = 0;   ///< samples
  HistorySoFar rows_; ///< of the table
};

} // namespace Rhegma
