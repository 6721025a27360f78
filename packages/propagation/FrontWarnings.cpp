#include "propagation/FrontWarnings.hpp"

#include "base/IntensityText.hpp"
#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "propagation/HoopStress.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

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

/// The same as a stress intensity, " (K of G = 1.2 MPa m^0.5, 0.6 of K_Ic = 2 MPa m^0.5)", where the scene
/// gives K_Ic. That is of Toughness, from which the initiation toughness may differ.
std::string ofIntensity(double closest, const AdvanceRule& rule, const Options& options)
{
  if (!(options.criticalIntensity > 0.0 && closest > 0.0))
    return {};
  const double root = std::sqrt(closest * rule.initiation / rule.toughness(0.0, rule.temperature));
  return " (K of G = " + intensityAsText(root * options.criticalIntensity) + ", " + formatShort(root) +
         " of K_Ic = " + intensityAsText(options.criticalIntensity) + ")";
}

/// ", K_II is 23 % of K_I at the end". \param entry of the front
std::string shearAtEnd(const nlohmann::json& entry, int dimension)
{
  const auto ratio = [&](const char* name)
  {
    const nlohmann::json value = entry.value(name, nlohmann::json());
    return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
  };
  const std::string text = shearOfComparison(ratio("K_II_over_K_I"), ratio("K_III_over_K_I"), dimension);
  return text.empty() ? text : "; at the end " + text;
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
                const AdvanceRule& rule, const Options& options, nlohmann::json& summary)
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
      reachedAtMost(closest.release, !closed && state.method.equilibrium()) +
      ofIntensity(closest.release, rule, options) + effectOfShearAtRest(entry) + shearAtEnd(entry, D) +
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
                         const Options&, nlohmann::json&);
template void reportRest(const State<3>&, const CrackFront<3>&, const Closest&, const AdvanceRule&,
                         const Options&, nlohmann::json&);

} // namespace Rhegma::propagation
