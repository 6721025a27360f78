#include "propagation/FirstAdvance.hpp"

#include "base/IntensityText.hpp"
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

/// Whether a front advanced as soon as the start time let it, with G above its toughness before.
template <int D>
bool wasHeld(const State<D>& state, const Options& options, const FrontState<D>& own)
{
  const double start = options.rule.startTime;
  if (!(start > 0.0) || own.increments == 0)
    return false;
  // Growth in equilibrium is that of the end of a load step: of the one in which the start time lies. G
  // reached the toughness within it, or before.
  constexpr double rounding = 1e-9;
  const auto& path = state.cracks.growth.path;
  if (path.empty() || own.firstTime > path.front().time)
    return own.first.held;
  return path.front().from < (1.0 - rounding) * start &&
         (own.early() >= 1.0 || path.front().reached <= (1.0 + rounding) * start);
}

} // namespace

template <int D>
void reportFirstAdvance(const State<D>& state, const Options& options, const FrontState<D>& own,
                        nlohmann::json& entry)
{
  const bool moved = own.increments > 0;
  const auto known = [](bool is, double value) { return is ? nlohmann::json(value) : nlohmann::json(); };
  entry["start_release"] = known(moved, own.first.release);
  entry["start_K_I"] = known(moved, own.first.modeI);
  entry["start_K_II"] = known(moved, own.first.modeII);
  if (D == 3)
    entry["start_K_III"] = known(moved, own.first.modeIII);
  entry["release_before_start_time"] = known(own.early() > 0.0, own.early());
  entry["held_until_start_time"] = wasHeld(state, options, own);
}

std::string holdAsText(const Options& options, const nlohmann::json& front)
{
  const std::string start = readableTime(options.rule.startTime);
  if (front.value("held_until_start_time", false))
    return ", held by Propagation > Start Time until " + start + ": it started at " +
           formatShort(front["start_release"].get<double>()) + " times the initiation toughness";
  const nlohmann::json early = front.value("release_before_start_time", nlohmann::json());
  if (!early.is_number() || !(early.get<double>() >= 1.0))
    return {};
  return " (before Propagation > Start Time = " + start + " G had reached " +
         formatShort(early.get<double>()) + " times the initiation toughness)";
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

std::string shearAtStart(const nlohmann::json& front)
{
  if (!front.contains("start_K_III") || !front["start_K_III"].is_number())
    return {};
  const auto ratio = [&](const char* name)
  { return front[name].get<double>() / front["start_K_I"].get<double>(); };
  if (!(front["start_K_I"].get<double>() > 0.0))
    return {};
  const std::string text = shearOfComparison(ratio("start_K_II"), ratio("start_K_III"), 3);
  return text.empty() ? text : "as it started, " + text;
}

template void reportFirstAdvance(const State<2>&, const Options&, const FrontState<2>&, nlohmann::json&);
template void reportFirstAdvance(const State<3>&, const Options&, const FrontState<3>&, nlohmann::json&);

} // namespace Rhegma::propagation
