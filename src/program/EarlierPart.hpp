#pragma once
/// The output of a run before its checkpoint.

#include "output/History.hpp"

#include <string>
#include <vector>

namespace Rhegma::program
{

/// Finds the history and the fields of a run next to its checkpoint, or in the folder in which it continues.
class EarlierPart
{
public:
  EarlierPart() = default; ///< a run from its start

  /// Changes nothing. Throws std::invalid_argument where a history exists that does not belong to the
  /// checkpoint.
  EarlierPart(const std::string& checkpoint, const std::string& folder, const HistorySoFar& soFar);

  bool exists() const { return exists_; }
  const HistorySoFar& history() const { return soFar_; }

  /// Copies history.csv, fields.h5, fronts.h5 and fronts.csv to the folder and removes other files of an
  /// older run there. Throws OutputError when they can't be written.
  void bring() const;

  /// Warnings for the user.
  const std::vector<std::string>& warnings() const { return warnings_; }

private:
  bool exists_ = false;
  std::string folder_, source_;
  HistorySoFar soFar_;
  std::vector<std::string> warnings_;
};

} // namespace Rhegma::program
