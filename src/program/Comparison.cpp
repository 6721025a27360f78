#include "program/Comparison.hpp"

#include "base/ShortNumber.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Rhegma::program
{

namespace
{

using nlohmann::json;

/// Change of an answer that counts as resolved.
constexpr double resolvedChange = 0.05;

/// No extrapolation from a larger change: cells are too large for an order to hold.
constexpr double largestExtrapolated = 0.25;

/// What to do where the runs, one of them or a front did not come to its end.
std::string adviceAfter(RunEnd asIs, RunEnd half)
{
  switch (std::max(asIs, half))
  {
  case RunEnd::Finished:
    break;
  case RunEnd::NotAtRest:
    return "raise Time > Final Time or change Damping, until both runs settle";
  case RunEnd::CutOff:
    return "raise Time > Maximum Steps";
  case RunEnd::Stopped:
  case RunEnd::Signalled:
    if (asIs == half)
      return "see why the runs stopped";
    if (half == RunEnd::Finished)
      return "the run finishes with half the cell size: use that size, and compare again with half of it";
    return isFinished(half) ? "see why the run stops with the cells of the scene"
                            : "see why the run stops with half the cell size";
  }
  return "use smaller cells";
}

/// What keeps an answer from being judged.
std::string reasonText(RunEnd end)
{
  return end == RunEnd::Stopped ? "a run stopped" : std::string("a run was ") + nameOf(end);
}

std::string cellsText(double cells) { return formatShort(cells) + (cells == 1.0 ? " cell" : " cells"); }

} // namespace

void Comparison::value(const std::string& name, const std::string& unit, double asIs, double half, int order,
                       double unseen, const json& more)
{
  if (std::isnan(asIs) && std::isnan(half))
    return;
  json answer = {{"name", name}, {"unit", unit}, {"as_is", asIs}, {"half", half}};
  answer.update(more);
  if (asIs == 0.0 && half == 0.0)
  {
    answer["change"] = 0.0;
    answer["resolved"] = false;
    answer["verdict"] = "zero in both: not compared";
    return answers_.push_back(std::move(answer));
  }
  known_ = true;
  if (std::isnan(asIs) || std::isnan(half))
    return add(answer, false,
               std::isnan(asIs) ? "none in the scene as it is" : "none with half the cell size");
  const double scale = std::max(std::fabs(half), std::numeric_limits<double>::min());
  const double change = asIs == half ? 0.0 : (half - asIs) / scale;
  answer["change"] = change;
  if (order > 0 && !unfinished_ && std::fabs(change) <= largestExtrapolated)
  {
    answer["order"] = order;
    answer["extrapolated"] = half + (half - asIs) / (std::pow(2.0, order) - 1.0);
    answer["extrapolated_order_2"] = half + (half - asIs) / 3.0;
  }
  if (std::fabs(half - asIs) <= unseen)
    return add(answer, true, "differs by less than a time step");
  add(answer, std::fabs(change) <= resolvedChange, "moves by " + formatShort(100.0 * change) + " %");
}

void Comparison::distance(const std::string& name, double distance)
{
  if (std::isnan(distance))
    return;
  known_ = true;
  const double cells = distance / cell_;
  add({{"name", name}, {"unit", "m"}, {"distance", distance}, {"cells", cells}}, cells <= 1.0,
      "differs by " + cellsText(cells));
}

void Comparison::word(const std::string& name, const std::string& asIs, const std::string& half)
{
  add({{"name", name}, {"unit", ""}, {"as_is", asIs}, {"half", half}}, asIs == half,
      asIs == half ? "the same" : "differs");
}

void Comparison::ends(const std::string& name, RunEnd asIs, RunEnd half)
{
  unfinished_ = std::max(asIs, half);
  advice_ = adviceAfter(asIs, half);
  add({{"name", name}, {"unit", ""}, {"as_is", nameOf(asIs)}, {"half", nameOf(half)}}, false,
      asIs == half ? std::string("both ") + nameOf(asIs) : "differs");
}

json Comparison::result() const
{
  const bool resolved = open_.empty() && known_;
  const std::string verdict = answers_.empty() ? "nothing to compare: the scene has no crack, temperature or "
                                                 "Reference"
                              : open_.empty() && !known_
                                  ? "nothing to compare: all results are zero in both runs; see whether "
                                    "loads act, and come to the crack before Time > Final Time"
                              : resolved ? "resolved: no result moves by more than 5 %, no path or "
                                           "position by more than a cell"
                                         : "not resolved: " + open_ + "; " + advice_;
  return {
      {"answers", answers_}, {"resolved", resolved}, {"open", open_}, {"verdict", verdict}, {"cell", cell_}};
}

void Comparison::add(json answer, bool resolved, const std::string& what)
{
  if (!resolved)
    open_ += (open_.empty() ? "" : "; ") + answer["name"].get<std::string>() + " (" + what + ")";
  const bool judged = !unfinished_ || earlier_;
  answer["resolved"] = resolved && judged;
  answer["verdict"] = what + (!resolved ? ": not resolved"
                              : judged  ? ": resolved"
                                        : ": not judged, as " + reasonText(*unfinished_));
  answers_.push_back(std::move(answer));
}

} // namespace Rhegma::program
