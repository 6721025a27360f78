#include "energy_release/ToughnessReached.hpp"

#include "archive/Archive.hpp"
#include "base/IntensityText.hpp"
#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "material/LawStiffness.hpp"
#include "material/StartOfGrowth.hpp"
#include "transfer/FrontCompliance.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace Rhegma::energy_release
{

namespace
{

/// K of the largest hoop stress over that at which the front starts. \param release G over the toughness
double hoopIntensity(double release, double modeI, double modeII)
{
  return std::sqrt(std::max(release, 0.0)) / hoopStressLoad(hoopStressAngle(std::max(modeI, 0.0), modeII));
}

constexpr double leastEffect = 1.005; ///< on a load that is worth a word

/// Least root of G/Gc that says something of the loads at which a crack starts. That of a crack which is
/// pressed shut is what is left of the forces by the solver, 1e-8 of them or less.
constexpr double leastFraction = 1e-6;

/// What nodes at the surface have, where it is more; else nothing.
std::string surfaceAsText(double release, double atSurface)
{
  if (!(atSurface > leastEffect * leastEffect * release))
    return {};
  return ", without the nodes less than two cells from the surface, where G depends on the cells (" +
         formatShort(atSurface) + ")";
}

/// "; K_II is 23 % of K_I": the shear at a front at the end. \param entry of the front
std::string shearAtEnd(const nlohmann::json& entry, int dimension)
{
  const auto ratio = [&](const char* name)
  {
    const nlohmann::json value = entry.value(name, nlohmann::json());
    return value.is_number() ? value.get<double>() : FrontSample<2>::notYet;
  };
  const std::string text = shearOfComparison(ratio("K_II_over_K_I"), ratio("K_III_over_K_I"), dimension);
  return text.empty() ? text : "; " + text;
}

/// Whether G is proportional to the square of all loads: one static solution of linear bodies without contact
/// and heat.
template <int D>
bool isProportional(const State<D>& state, const RunOptions& run)
{
  const auto& bodies = state.bodies.info;
  return state.method.analysis == Analysis::Static && !run.contact && !run.heat() && !run.bodiesKeptApart &&
         std::all_of(bodies.begin(), bodies.end(),
                     [&](const auto& body) { return isLinear(state.materials.properties[body.material]); });
}

/// Whether times of samples are those of loads: of a static state they only count parts of the loads.
template <int D>
bool hasTimes(const State<D>& state)
{
  return state.method.analysis != Analysis::Static && state.method.analysis != Analysis::LoadFactor;
}

} // namespace

void StartTime::add(double time, double ratio)
{
  if (!isKnown() && ratio >= 1.0)
  {
    isFirst_ = !std::isfinite(lastRatio_);
    const double before = std::sqrt(std::max(lastRatio_, 0.0)), now = std::sqrt(ratio);
    time_ = isFirst_ ? time : lastTime_ + (time - lastTime_) * (1.0 - before) / (now - before);
  }
  lastTime_ = time;
  lastRatio_ = ratio;
}

std::string StartTime::asText() const
{
  if (!isKnown())
    return {};
  return isFirst_ ? "; G exceeds the toughness at the first sample already, at t = " + readableTime(time_)
                  : "; G came to the toughness at about t = " + readableTime(time_);
}

StartTime StartTime::of(const double* row)
{
  StartTime start;
  start.time_ = row[0];
  start.isFirst_ = row[1] > 0.5;
  start.lastTime_ = row[2];
  start.lastRatio_ = row[3];
  return start;
}

void ToughnessReached::assumeIntensity(const std::vector<Properties>& materials)
{
  constexpr double rounding = 1e-9;
  double modulus = 0.0;
  bool one = toughness_ > 0.0 && !(criticalIntensity_ > 0.0);
  for (const Properties& material : materials)
  {
    const double own = elasticity(material).effectiveModulus;
    one = one && own > 0.0 && !isAnisotropic(material) &&
          (modulus == 0.0 || std::fabs(own - modulus) <= rounding * modulus);
    modulus = own;
  }
  if (one && modulus > 0.0)
    criticalIntensity_ = std::sqrt(modulus * toughness_);
}

/// How close a front came to its start, as text.
std::string ToughnessReached::reachedAsText(const Reached& reached) const
{
  const double root = std::sqrt(std::max(reached.release, 0.0));
  std::string text = "G reached " + formatShort(reached.release) + " of the toughness of " +
                     formatShort(toughness_) + " J/m2";
  if (criticalIntensity_ > 0.0)
    text += " (K of G = " + intensityAsText(root * criticalIntensity_) + ", " + formatShort(root) +
            " of K_Ic = " + intensityAsText(criticalIntensity_) + ")";
  if (reached.intensity > leastEffect * root)
    text +=
        ", and K of the largest hoop stress " + formatShort(reached.intensity) + " of that of the toughness";
  return text;
}

template <int D>
void ToughnessReached::add(const State<D>& state, const std::vector<FrontSample<D>>& samples)
{
  for (const FrontSample<D>& sample : samples)
  {
    if (!(toughness_ > 0.0) || sample.front.ended)
      continue;
    const std::vector<char> atSurface = nodesAtSurface(state, sample.front, mirrors_);
    const bool turns = D == 2 && isIsotropicAt(state, sample.front); // by the isotropic hoop stress
    const ModeRelease modes = modeReleaseAt(state, sample.front);
    double now = FrontSample<D>::notYet; // largest of the nodes that are not at the surface
    for (std::size_t k = 0; k < sample.J.size(); ++k)
    {
      const double modeIII = D == 3 ? sample.modeIII[k] : 0.0;
      if (!std::isfinite(sample.J[k]))
        continue;
      Reached& reached = reached_[{sample.front.crack, sample.front.number}];
      const double release =
          openingRelease(sample.J[k], sample.modeI[k], sample.modeII[k], modeIII, modes) / toughness_;
      double& largest = atSurface[k] != 0 ? reached.atSurface : reached.release;
      largest = std::max(largest, release);
      if (atSurface[k] == 0)
        now = std::isfinite(now) ? std::max(now, release) : release;
      if (turns)
        reached.intensity =
            std::max(reached.intensity, hoopIntensity(release, sample.modeI[k], sample.modeII[k]));
    }
    if (std::isfinite(now))
      reached_[{sample.front.crack, sample.front.number}].start.add(state.clock.time, now);
  }
}

template <int D>
ToughnessReached::Factors ToughnessReached::report(const State<D>& state, const RunOptions& run,
                                                   nlohmann::json& summary) const
{
  if (!(toughness_ > 0.0))
    return {};
  double mostAtSurface = 0.0;
  double most = 0.0; // largest root of G or K, over what the toughness allows
  for (const CrackFront<D>& front : state.cracks.fronts)
  {
    nlohmann::json& entry = summary["cracks"][front.crack]["fronts"][front.number];
    const auto found = reached_.find({front.crack, front.number});
    const bool known = found != reached_.end();
    entry["closest_to_initiation"] = known ? found->second.release : FrontSample<D>::notYet;
    const bool timed = known && hasTimes(state);
    entry["time_of_toughness"] = timed ? found->second.start.time() : FrontSample<D>::notYet;
    if (D == 2)
      entry["closest_by_hoop_stress"] =
          known && isIsotropicAt(state, front) ? found->second.intensity : FrontSample<D>::notYet;
    else
      entry["closest_at_surface"] = known ? found->second.atSurface : FrontSample<D>::notYet;
    if (!known)
      continue;
    const auto& [release, atSurface, intensity, start] = found->second;
    most = std::max({most, std::sqrt(release), intensity});
    mostAtSurface = std::max(mostAtSurface, std::sqrt(atSurface));
    summary["answers"].push_back(frontName(state.cracks, front) + ": " + reachedAsText(found->second) +
                                 shearAtEnd(entry, D) + surfaceAsText(release, atSurface) +
                                 (timed ? start.asText() : std::string()));
  }
  const bool scales = isProportional(state, run) && most > leastFraction;
  // Static loads rise in proportion to the time.
  const double part = state.clock.finalTime > 0.0 ? state.clock.time / state.clock.finalTime : 1.0;
  summary["start_of_growth"] = {{"toughness", toughness_},
                                {"load_factor", scales ? part / most : FrontSample<D>::notYet},
                                {"factor_at_end", scales ? 1.0 / most : FrontSample<D>::notYet}};
  if (criticalIntensity_ > 0.0)
    summary["start_of_growth"]["K_Ic"] = criticalIntensity_;
  if (!scales)
    return {1.0, 1.0, toughness_};
  if (D == 3)
    summary["start_of_growth"]["load_factor_at_surface"] =
        mostAtSurface > 0.0 ? part / mostAtSurface : FrontSample<D>::notYet;
  summary["answers"].push_back(
      "cracks would start at " + formatShort(part / most) +
      " times the loads and prescribed displacements of this scene" +
      (mostAtSurface > leastEffect * most ? " (at " + formatShort(part / mostAtSurface) +
                                                " times them by the nodes at the surface, which are left out)"
                                          : "") +
      (part < 1.0 ? ", of which it applied " + formatShort(100.0 * part) + " %" : ""));
  return {1.0 / most, part / most, toughness_};
}

void ToughnessReached::serialize(Archive& archive)
{
  constexpr std::size_t own = 5, width = own + StartTime::width;
  std::vector<double> rows;
  for (const auto& [front, reached] : reached_)
  {
    rows.insert(rows.end(), {double(front.first), double(front.second), reached.release, reached.atSurface,
                             reached.intensity});
    const std::vector<double> start = reached.start.row();
    rows.insert(rows.end(), start.begin(), start.end());
  }
  archive("closest_to_toughness", rows, width);
  reached_.clear();
  for (std::size_t k = 0; k + width <= rows.size(); k += width)
    reached_[{static_cast<int>(rows[k]), static_cast<int>(rows[k + 1])}] = {
        rows[k + 2], rows[k + 3], rows[k + 4], StartTime::of(&rows[k + own])};
}

template void ToughnessReached::add(const State<2>&, const std::vector<FrontSample<2>>&);
template void ToughnessReached::add(const State<3>&, const std::vector<FrontSample<3>>&);
template ToughnessReached::Factors ToughnessReached::report(const State<2>&, const RunOptions&,
                                                            nlohmann::json&) const;
template ToughnessReached::Factors ToughnessReached::report(const State<3>&, const RunOptions&,
                                                            nlohmann::json&) const;

} // namespace Rhegma::energy_release
