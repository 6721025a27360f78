#include "propagation/FrontWarnings.hpp"

#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace Rhegma::propagation
{

namespace
{

/// \param closest largest G over its initiation toughness, below one
std::string reachedAtMost(double closest)
{
  constexpr double least = 0.001;
  if (!(closest > 0.0))
    return "G was never above 0: no load has come to the front";
  if (closest < least)
    return "G stayed below " + formatReal(least) + " of the initiation toughness";
  return "G reached at most " + formatReal(least * std::floor(closest / least)) +
         " of the initiation toughness";
}

} // namespace

template <int D>
void reportRest(const State<D>& state, const CrackFront<D>& front, double closest, double startTime,
                nlohmann::json& summary)
{
  nlohmann::json& entry = summary["cracks"][front.crack]["fronts"][front.number];
  entry["closest_to_initiation"] = closest;
  if (state.clock.step == 0) // a scene that is only checked
    return;
  if (state.clock.time < startTime)
  {
    summary["warnings"].push_back(
        frontName(state.cracks, front) + ": no crack may advance before " + readableTime(startTime) +
        " (Propagation > Start Time), and the run ended at " + readableTime(state.clock.time));
    return;
  }
  const bool closed = entry.value("closed", false); // by Energy Release
  summary["warnings"].push_back(
      frontName(state.cracks, front) + ": not initiated" +
      (closed ? ", and closed at the end (K_I < 0); counting also the G that closes it, " : "; ") +
      reachedAtMost(closest));
}

void compareContours(const std::string& name, double release, const nlohmann::json& entry,
                     nlohmann::json& summary)
{
  constexpr double most = 0.1;
  const auto found = entry.find("G_J");
  if (found == entry.end() || !found->is_number() || !(release > 0.0))
    return;
  const double ratio = found->get<double>() / release;
  if (std::fabs(ratio - 1.0) > most)
    summary["warnings"].push_back(name + ": grows at G = " + formatShort(release) +
                                  " J/m2 of its Release Contour, but G_J of Energy Release is " +
                                  formatShort(100.0 * ratio) +
                                  " % of that: one of these contours is next to a surface, a load or another "
                                  "crack, or has few cells; use smaller cells (Domain > Cell Size)");
}

template void reportRest(const State<2>&, const CrackFront<2>&, double, double, nlohmann::json&);
template void reportRest(const State<3>&, const CrackFront<3>&, double, double, nlohmann::json&);

} // namespace Rhegma::propagation
