#pragma once
/// What the part of a run before its checkpoint left.

#include "output/History.hpp"

#include <string>
#include <vector>

namespace Rhegma::program
{

/// Finds the history and the fields of a run next to its checkpoint, or in the folder in which it goes on.
class EarlierPart
{
public:
  EarlierPart() = default; ///< a run from its start

  /// Looks and changes nothing. Throws std::invalid_argument where a history is there that is not the one
  /// that the checkpoint goes on from.
  EarlierPart(const std::string& checkpoint, const std::string& folder, const HistorySoFar& soFar);

  bool exists() const { return exists_; }
  const HistorySoFar& history() const { return soFar_; }

  /// Brings history.csv and fields.h5 to the folder and removes all else that an older run left there. Throws
  /// OutputError when they can't be written.
  void bring() const;

  /// What a user should know, in sentences.
  const std::vector<std::string>& warnings() const { return warnings_; }

private:
  bool exists_ = false;
  std::string folder_, source_;
  HistorySoFar soFar_;
  std::vector<std::string> warnings_;
};

} // namespace Rhegma::program
