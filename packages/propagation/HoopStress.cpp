#include "propagation/HoopStress.hpp"

#include "base/ShortNumber.hpp"
#include "material/StartOfGrowth.hpp"
#include "transfer/FrontCompliance.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

namespace Rhegma::propagation
{

namespace
{

constexpr double never = std::numeric_limits<double>::infinity();
constexpr double unknown = std::numeric_limits<double>::quiet_NaN(); ///< null in the summary

/// Loads above this fraction are not worth a word [-].
constexpr double leastEffectOfShear = 0.995;

/// Smallest G over the toughness of a front that starts by the largest hoop stress: that of shear alone.
constexpr double leastRelease = 0.75;

/// A number of the entry of a front; another one where it has none.
double numberOf(const nlohmann::json& front, const char* name, double otherwise)
{
  const auto entry = front.find(name);
  if (entry == front.end() || !entry->is_number() || !std::isfinite(entry->get<double>()))
    return otherwise;
  return entry->get<double>();
}

/// Load at which the largest hoop stress makes a front start, over that of a straight extension; 1 if
/// unknown.
double loadOf(const nlohmann::json& front) { return numberOf(front, "hoop_stress_load", 1.0); }

/// A front of a summary, and the name of its crack.
struct NamedFront
{
  nlohmann::json entry;
  std::string crack;
};

/// The front with the smallest of what `order` says of its entry.
template <class Order>
NamedFront smallest(const nlohmann::json& summary, const Order& order)
{
  NamedFront found;
  for (const nlohmann::json& crack : summary.value("cracks", nlohmann::json::array()))
    for (const nlohmann::json& front : crack.value("fronts", nlohmann::json::array()))
      if (front.is_object() && (found.entry.is_null() || order(front) < order(found.entry)))
        found = {front, crack.value("name", std::string())};
  return found;
}

/// The first front to be initiated; of those that start at the same time the one with the largest effect.
NamedFront firstOf(const nlohmann::json& summary)
{
  return smallest(summary, [](const nlohmann::json& front)
                  { return std::make_pair(numberOf(front, "initiated", never), loadOf(front)); });
}

std::string textOf(const char* format, double a, double b = 0.0)
{
  char text[192];
  std::snprintf(text, sizeof text, format, a, b);
  return text;
}

/// Whether a front may start by the largest hoop stress, as far as it is looked for.
bool isAtRest(const CrackFront<2>& front, const FrontState<2>& own)
{
  return !front.ended && own.increments == 0 && !front.nodes.empty() && !front.nodes[0].stopped;
}

} // namespace

void markMeasured(State<2>& state, const Options& options, const std::vector<FrontState<2>>& fronts)
{
  const double now = state.clock.time + state.clock.dt;
  for (std::size_t f = 0; f < state.cracks.fronts.size(); ++f)
  {
    CrackFront<2>& front = state.cracks.fronts[f];
    front.measured = false;
    if (options.ratio) // the direction decides on the start
    {
      front.measured = front.due && !front.ended && !front.nodes.empty() && !front.nodes[0].stopped;
      continue;
    }
    if (options.equilibrium || options.direction == DirectionRule::Straight || !front.due ||
        !isAtRest(front, fronts[f]) || front.advances() || now < options.rule.startTime)
      continue;
    const double most = std::max(1.0, fronts[f].hoop.intensity);
    const FrontNode<2>& node = front.nodes[0];
    front.measured =
        !node.driving.lost &&
        node.driving.release > leastRelease * most * most * ruleAt(node.temperature, options).initiation;
  }
}

void markMeasured(State<3>&, const Options&, const std::vector<FrontState<3>>&) {}

void recordHoopStart(const State<2>& state, const Options& options, std::vector<FrontState<2>>& fronts)
{
  const bool hasFactor = state.method.analysis == Analysis::LoadFactor;
  const double now = state.clock.time + state.clock.dt;
  if (hasFactor ? !state.cracks.growth.path.empty() : !hasStarted(now, options.rule.startTime))
    return;
  for (std::size_t f = 0; f < state.cracks.fronts.size(); ++f)
  {
    const CrackFront<2>& front = state.cracks.fronts[f];
    if (options.ratio || !isAtRest(front, fronts[f]) || !(front.measured || front.advances()))
      continue;
    const FrontNode<2>& node = front.nodes[0];
    const ModeRelease modes = modeReleaseAt(state, front);
    const double release = openingRelease(node.driving, modes) / ruleAt(node.temperature, options).initiation;
    const double load = hoopStressLoad(node.driving.hoopAngle);
    const double intensity =
        std::sqrt(std::max(release, 0.0)) / load / (hasFactor ? state.clock.factor.end : 1.0);
    if (hasFactor || intensity > fronts[f].hoop.intensity)
      fronts[f].hoop = {load, intensity};
  }
}

void recordHoopStart(const State<3>&, const Options&, std::vector<FrontState<3>>&) {}

void reportHoopStart(const State<2>& state, const Options& options, const FrontState<2>& own,
                     nlohmann::json& entry)
{
  const bool known = options.direction != DirectionRule::Straight && own.hoop.intensity > 0.0;
  const bool hasFactor = state.method.analysis == Analysis::LoadFactor, moved = own.increments > 0;
  entry["hoop_stress_load"] = known && (moved || hasFactor) ? own.hoop.load : unknown;
  if (hasFactor)
    entry["hoop_stress_factor"] = known ? 1.0 / own.hoop.intensity : unknown;
  else
    entry["closest_by_hoop_stress"] = known && !moved ? own.hoop.intensity : unknown;
}

void reportHoopStart(const State<3>&, const Options&, const FrontState<3>&, nlohmann::json&) {}

std::string effectOfShear(const nlohmann::json& front)
{
  const double load = loadOf(front), turn = numberOf(front, "first_turn", unknown);
  if (load > leastEffectOfShear || std::isnan(turn))
    return {};
  return textOf("it turned by %.0f degrees as it started, for which the largest hoop stress needs about %.2f "
                "of the load",
                std::fabs(turn), load);
}

std::string effectOfShearOnFirst(const nlohmann::json& summary)
{
  const NamedFront first = firstOf(summary);
  const std::string text = effectOfShear(first.entry);
  return text.empty() ? text : "; of a front of crack " + first.crack + ": " + text;
}

std::string effectOfShearOnFactor(double factor, const nlohmann::json& summary)
{
  const NamedFront first = firstOf(summary);
  const std::string loads = " times the loads of Time > Final Time";
  const std::string text = effectOfShear(first.entry);
  const double turned = loadOf(first.entry) * factor;
  const bool anyStarted = !first.entry.is_null() && numberOf(first.entry, "initiated", never) < never;
  const auto factorOf = [](const nlohmann::json& front)
  { return numberOf(front, "hoop_stress_factor", never); };
  const NamedFront lowest = smallest(summary, factorOf);
  const double least = lowest.entry.is_null() ? never : factorOf(lowest.entry);
  if (least < leastEffectOfShear * (text.empty() ? factor : turned))
    return "; by the largest hoop stress a front of crack " + lowest.crack + " starts at " +
           formatShort(least) + loads +
           (numberOf(lowest.entry, "initiated", never) < never || !anyStarted ? ""
                                                                              : ", which by G did not start");
  return text.empty()
             ? text
             : "; of a front of crack " + first.crack + ": " + text + ", " + formatShort(turned) + loads;
}

std::string effectOfShearAtRest(const nlohmann::json& front)
{
  const double intensity = numberOf(front, "closest_by_hoop_stress", 0.0);
  const double release = numberOf(front, "closest_to_initiation", never);
  if (!(std::sqrt(release) < leastEffectOfShear * intensity))
    return {};
  if (intensity < 1.0)
    return textOf(", and K of the largest hoop stress %.3f of the toughness",
                  1e-3 * std::floor(1e3 * intensity));
  return textOf(
      ", but by the largest hoop stress K is %.2f times the toughness: with shear the crack starts at "
      "%.2f of this load",
      intensity, 1.0 / intensity);
}

} // namespace Rhegma::propagation
