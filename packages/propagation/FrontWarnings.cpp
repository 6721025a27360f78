#include "propagation/FrontWarnings.hpp"

#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "propagation/HoopStress.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace Rhegma::propagation
{

namespace
{

/// A fraction in thousandths, rounded down: below one it stays so.
std::string inThousandths(double fraction) { return formatReal(1e-3 * std::floor(1e3 * fraction)); }

/// \param closest largest G over its initiation toughness \param relieved whether other fronts grew
std::string reachedAtMost(double closest, bool relieved)
{
  constexpr double least = 0.001;
  if (!(closest > 0.0))
    return "G was never above 0: no load has come to the front";
  if (closest < least)
    return "G stayed below " + formatReal(least) + " of the initiation toughness";
  return "G reached at most " + inThousandths(closest) + " of the initiation toughness" +
         (closest >= 1.0 && relieved ? ", until the growth of other fronts reduced it" : "");
}

/// What G over the initiation toughness was before the start time; empty where that was below it.
std::string reachedBefore(double early, const nlohmann::json& entry, const AdvanceRule& rule)
{
  const double largest = entry.value("largest_G_J", nlohmann::json()).is_number() &&
                                 entry.value("time_of_largest_G_J", 0.0) < rule.startTime
                             ? entry["largest_G_J"].get<double>() / rule.initiation
                             : 0.0; // of samples, in motion
  early = std::max(early, largest);
  return early < 1.0
             ? std::string()
             : ". Before Propagation > Start Time = " + readableTime(rule.startTime) + " G reached " +
                   inThousandths(early) + " of the initiation toughness, but no crack may advance then";
}

} // namespace

template <int D>
void reportRest(const State<D>& state, const CrackFront<D>& front, const Closest& closest,
                const AdvanceRule& rule, nlohmann::json& summary)
{
  nlohmann::json& entry = summary["cracks"][front.crack]["fronts"][front.number];
  entry["closest_to_initiation"] = closest.release;
  if (state.clock.step == 0) // a scene that is only checked
    return;
  const std::string before = reachedBefore(closest.early, entry, rule);
  if (!hasStarted(state.clock.time, rule.startTime))
  {
    summary["warnings"].push_back(
        frontName(state.cracks, front) + ": no crack may advance before " + readableTime(rule.startTime) +
        " (Propagation > Start Time), and the run ended at " + readableTime(state.clock.time) + before);
    return;
  }
  const bool closed = entry.value("closed", false); // by Energy Release
  summary["warnings"].push_back(
      frontName(state.cracks, front) + ": not initiated" +
      (closed ? ", and closed at the end (K_I < 0); counting also the G that closes it, " : "; ") +
      reachedAtMost(closest.release, !closed && state.method.equilibrium()) + effectOfShearAtRest(entry) +
      before);
}

void compareContours(const std::string& name, const ContourDifference& largest, nlohmann::json& summary)
{
  constexpr double most = 0.1;
  if (std::fabs(largest.ratio - 1.0) > most)
    summary["warnings"].push_back(
        name + ": at t = " + readableTime(largest.time) + " it grows at G = " + formatShort(largest.release) +
        " J/m2 of its Release Contour, but G_J of Energy Release is " + formatShort(100.0 * largest.ratio) +
        " % of that: one of these domain integrals is next to a surface, a load or another crack, or has few "
        "cells, "
        "and the load at which the crack grows can be wrong by the root of it; use smaller cells (Domain > "
        "Cell Size)");
}

template void reportRest(const State<2>&, const CrackFront<2>&, const Closest&, const AdvanceRule&,
                         nlohmann::json&);
template void reportRest(const State<3>&, const CrackFront<3>&, const Closest&, const AdvanceRule&,
                         nlohmann::json&);

} // namespace Rhegma::propagation
