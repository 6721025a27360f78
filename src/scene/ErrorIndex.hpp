#pragma once
/// Errors found by their position, however many there are.

#include "scene/SceneError.hpp"

#include <set>
#include <string>
#include <vector>

namespace Rhegma
{

/// Looks into a list of errors that grows while it is in use; each error is read once.
class ErrorIndex
{
public:
  explicit ErrorIndex(const std::vector<SceneError>& errors) : errors_(errors) {}

  /// Whether an error stands at a position.
  bool has(const std::string& where) const { return positions().count(where) > 0; }

  /// Whether one stands at a position below, other than `aside`.
  bool hasBelow(const std::string& where, const std::string& aside) const
  {
    const std::string start = where + " > ";
    const std::set<std::string>& all = positions();
    for (auto at = all.lower_bound(start); at != all.end() && at->compare(0, start.size(), start) == 0; ++at)
      if (*at != aside)
        return true;
    return false;
  }

private:
  const std::set<std::string>& positions() const
  {
    for (; read_ < errors_.size(); ++read_)
      positions_.insert(errors_[read_].where);
    return positions_;
  }

  const std::vector<SceneError>& errors_;
  mutable std::set<std::string> positions_;
  mutable std::size_t read_ = 0;
};

} // namespace Rhegma
