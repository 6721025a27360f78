#pragma once
/// Collects the answers of two runs and judges how far they moved.

#include "program/RunEnd.hpp"

#include <nlohmann/json.hpp>

#include <limits>
#include <optional>
#include <string>

namespace Rhegma::program
{

constexpr double noNumber = std::numeric_limits<double>::quiet_NaN();

/// A number of a summary; not a number where it has none.
inline double numberOrNone(const nlohmann::json& object, const char* name)
{
  const auto at = object.find(name);
  return at != object.end() && at->is_number() ? at->get<double>() : noNumber;
}

/// Answers of a scene as it is and with cells of half the size. All are added before result() is called.
class Comparison
{
public:
  /// \param cell smallest of the scene as it is [m]
  explicit Comparison(double cell) : cell_(cell) {}

  /// A number of both runs; not a number where a run has none. \param order lowest that its error may have in
  /// the size of the cells; 0: not smooth, so not extrapolated. Nor are answers of runs that did not come to
  /// their end. \param unseen difference that is smaller than what the runs resolve, in `unit`
  /// \param more fields of the answer
  void value(const std::string& name, const std::string& unit, double asIs, double half, int order,
             double unseen = 0.0, const nlohmann::json& more = nlohmann::json::object());

  /// \param distance between what the runs found [m]; not a number: none
  void distance(const std::string& name, double distance);

  void word(const std::string& name, const std::string& asIs, const std::string& half);

  /// Of runs one of which, or both, or a front of which, did not come to its end: what comes after that is
  /// not known, and nothing is resolved but what is of earlier times. \param name of what is compared
  void ends(const std::string& name, RunEnd asIs, RunEnd half);

  /// Whether answers from now on are of times that both runs have passed.
  void areOfEarlierTimes(bool earlier) { earlier_ = earlier; }

  /// {"answers", "resolved", "open", "verdict", "cell"}, as compareRuns() describes them
  nlohmann::json result() const;

private:
  void add(nlohmann::json answer, bool resolved, const std::string& what);

  double cell_;
  nlohmann::json answers_ = nlohmann::json::array();
  std::string open_; ///< answers that are not resolved, and what of them
  std::string advice_ = "use smaller cells";
  bool known_ = false; ///< there is an answer that is not zero
  std::optional<RunEnd>
      unfinished_;       ///< why the answers are not those of the end of the scene; none: they are
  bool earlier_ = false; ///< see areOfEarlierTimes
};

} // namespace Rhegma::program
