#include "propagation/FirstAdvance.hpp"

#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace Rhegma::propagation
{

namespace
{

/// K_I of faces that press together, over K of both modes, below which it is named.
constexpr double noticeable = 0.05;

/// Whether a front has advanced as soon as the start time let it, with G above its toughness.
template <int D>
bool wasHeld(const State<D>& state, const Options& options, const FrontState<D>& own)
{
  const double start = options.rule.startTime;
  if (!(start > 0.0) || own.increments == 0)
    return false;
  if (own.early() >= 1.0)
    return true;
  constexpr double rounding = 1e-9;
  if (!options.equilibrium)
    return own.first.release > 1.0 && own.firstTime <= (1.0 + rounding) * start;
  // Growth is that of the end of a load step; G reached the toughness within it.
  const auto& path = state.cracks.growth.path;
  return !path.empty() && own.firstTime <= path.front().time &&
         path.front().reached <= (1.0 + rounding) * start;
}

} // namespace

template <int D>
void reportFirstAdvance(const State<D>& state, const Options& options, const FrontState<D>& own,
                        nlohmann::json& entry)
{
  const bool moved = own.increments > 0;
  entry["start_release"] =
      moved ? nlohmann::json(std::max(own.first.release, own.early())) : nlohmann::json();
  if (D == 2)
  {
    entry["start_K_I"] = moved ? nlohmann::json(own.first.modeI) : nlohmann::json();
    entry["start_K_II"] = moved ? nlohmann::json(own.first.modeII) : nlohmann::json();
  }
  entry["held_until_start_time"] = wasHeld(state, options, own);
}

std::string holdAsText(const Options& options, const nlohmann::json& front)
{
  if (!front.value("held_until_start_time", false))
    return {};
  return ", held by Propagation > Start Time until " + readableTime(options.rule.startTime) +
         ", by when G had reached " + formatShort(front["start_release"].get<double>()) +
         " times the initiation toughness";
}

std::string closureAsText(const nlohmann::json& front)
{
  if (!front.contains("start_K_I") || !front["start_K_I"].is_number())
    return {};
  constexpr double mega = 1e6;
  const double one = front["start_K_I"].get<double>() / mega, two = front["start_K_II"].get<double>() / mega;
  if (!(one < -noticeable * std::hypot(one, two)))
    return {};
  return "its faces pressed together as it started (K_I = " + formatShort(one) +
         ", K_II = " + formatShort(two) + " MPa m^0.5)";
}

template void reportFirstAdvance(const State<2>&, const Options&, const FrontState<2>&, nlohmann::json&);
template void reportFirstAdvance(const State<3>&, const Options&, const FrontState<3>&, nlohmann::json&);

} // namespace Rhegma::propagation
