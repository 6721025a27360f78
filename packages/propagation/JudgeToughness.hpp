#pragma once
/// Whether a toughness fits the loads, the material and the body
/// (docs/reference/warnings-of-cracks-and-runs.md).

#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "base/ShortNumber.hpp"
#include "material/LawStiffness.hpp"
#include "material/RayleighSpeed.hpp"
#include "plausibility/CrackExtent.hpp"
#include "plausibility/LoadEstimate.hpp"
#include "propagation/Options.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::propagation
{

/// Warns of a Speed Limit with which no front can advance by a cell, and of one that no crack reaches.
/// \param scene its core
template <int D>
void judgeSpeedLimit(const Teuchos::ParameterList& scene, const Options& options, State<D>& state)
{
  if (!(options.speedLimit > 0.0))
    return;
  const std::string where = "Propagation > Speed Limit is " + formatReal(options.speedLimit) + " m/s";
  const double time = scene.sublist("Time").get<double>("Final Time") - options.rule.startTime;
  const double length = options.speedLimit * time, cell = state.mesh.smallestSpacing();
  if (time > 0.0 && length < cell)
    state.warnings.push_back(
        where + ": a front advances by " + readableLength(length) +
        " at most up to Time > Final Time, less than a cell of " + readableLength(cell) +
        ", so beyond its first increment no crack grows: write a larger limit (m/s), or leave it "
        "out");
  double rayleigh = 0.0;
  bool anisotropic = false; // of which rayleighSpeed is a bound
  for (const Properties& material : state.materials.properties)
  {
    rayleigh = std::max(rayleigh, rayleighSpeed(material));
    anisotropic = anisotropic || isAnisotropic(material);
  }
  if (options.speedLimit > (1.0 + 1e-3) * rayleigh)
    state.warnings.push_back(
        where + ", " + formatShort(options.speedLimit / rayleigh) + " times the speed of " +
        (anisotropic ? "the slowest waves (" : "Rayleigh waves (") + formatShort(rayleigh) +
        " m/s), which no crack under tension passes: what fronts do faster than that has no meaning; " +
        (anisotropic ? "write the speed of Rayleigh waves in the direction of the crack"
                     : "leave it out, so that this is the limit") +
        ", and check its unit (m/s)");
}

/// A toughness, and the bodies that it is compared with.
template <int D>
struct JudgedToughness
{
  const State<D>& state;
  std::vector<BodyMeasure<D>> bodies;
  double atRest, most; ///< of the toughness, and of all speeds [J/m2]
  double slow, half;   ///< at a twentieth of the speed of Rayleigh waves, and up to half of it [J/m2]
  double crack;        ///< longest extent of the cracks behind their fronts [m]
  const BodyMeasure<D>*soft, *stiff;
  std::string where;  ///< parameter of the toughness at rest, and its value
  std::string rising; ///< the same of that which depends on speed
  static constexpr double pi = 3.14159265358979;

  JudgedToughness(const Options& options, const State<D>& judged)
      : state(judged),
        bodies(crackedBodies(judged)),
        atRest(std::max(options.rule.initiation, options.rule.toughness(0.0, options.temperature))),
        most(atRest),
        slow(atRest),
        half(atRest),
        crack(longestCrack(judged)),
        rising("Propagation > Toughness is " + formatReal(options.rule.toughness(0.0, options.temperature)) +
               " J/m2: ")
  {
    where = options.rule.initiation > options.rule.toughness(0.0, options.temperature)
                ? "Propagation > Initiation Toughness is " + formatReal(atRest) + " J/m2: "
                : rising;
    const auto by = [](const auto& a, const auto& b)
    { return a.moduli.effectiveModulus < b.moduli.effectiveModulus; };
    soft = &*std::min_element(bodies.begin(), bodies.end(), by);
    stiff = &*std::max_element(bodies.begin(), bodies.end(), by);
    for (const Properties& material : state.materials.properties)
      for (int k = 1; k <= 20; ++k)
      {
        const double speed = 0.05 * k * rayleighSpeed(material);
        if (options.speedLimit > 0.0 && speed > options.speedLimit)
          break;
        const double needed = options.rule.toughness(speed, options.temperature);
        most = std::max(most, needed);
        half = k <= 10 ? std::max(half, needed) : half;
        slow = k == 1 ? std::max(slow, needed) : slow;
      }
  }

  /// Stress at which the crack runs [Pa].
  double griffith(const BodyMeasure<D>& body, double toughness) const
  {
    return std::sqrt(body.moduli.effectiveModulus * toughness / (pi * crack));
  }

  static std::string advice()
  {
    return "; it is an energy in J/m2: from K_Ic in Pa m^0.5 it is K_Ic^2 / E', and "
           "1 MPa m^0.5 is 1e6 Pa m^0.5";
  }
};

/// Compares the toughness with what bonds take: with the surfaces of any solid, the toughest, and stiff
/// solids of small K_Ic = sqrt(E' Gc), which a K_Ic in MPa m^0.5 looks like where J/m2 are meant.
template <int D>
void judgeBonds(const JudgedToughness<D>& judged, std::vector<std::string>& messages)
{
  // Van der Waals solids take 0.05 J/m2 for two new surfaces, the toughest steels some 5e5 J/m2; of stiff
  // solids polyethylene has the largest Gc / E, 2e-5 m.
  const Elasticity& soft = judged.soft->moduli;
  const bool stiffSolid = soft.young > 1e9; // no rubber has that
  const auto isTough = [&](double Gc) { return Gc > 2e6 || (stiffSolid && Gc > 5e-5 * soft.young); };
  if (judged.most < 0.05 || isTough(judged.atRest))
    messages.push_back(judged.where +
                       (judged.most < 0.05 ? "less than the surface energy of any solid"
                                           : "more than that of any solid of this stiffness") +
                       judged.advice());
  else if (isTough(judged.half) || (stiffSolid && judged.slow > 10.0 * judged.atRest))
    messages.push_back(judged.rising + "it rises to " + formatShort(judged.slow) +
                       " J/m2 at a twentieth of the speed of Rayleigh waves and to " +
                       formatShort(judged.half) + " J/m2 at half of it, " +
                       (isTough(judged.half) ? "more than any solid of that stiffness takes"
                                             : "faster than in any stiff solid") +
                       ", so that no crack runs: speeds are in m/s");
  // Ice has the smallest K_Ic of solids of that stiffness, 1e5 Pa m^0.5. Where the stress next to a front
  // exceeds E / 10, bonds break: in E' Gc / (2 pi (E / 10)^2), of which single crystals that cleave have an
  // atom's distance or a little less.
  constexpr double smallestK = 1e5, atom = 0.2e-9;
  const double K = std::sqrt(soft.effectiveModulus * judged.most);
  const double zone =
      100.0 * soft.effectiveModulus * judged.most / (2.0 * judged.pi * soft.young * soft.young);
  const bool weak = K < smallestK;
  // What K_Ic is of anisotropic bodies depends on direction.
  if (judged.most < 0.05 || !stiffSolid || judged.soft->anisotropic || (!weak && zone >= atom))
    return;
  const double asK = 1e12 * judged.atRest * judged.atRest / soft.effectiveModulus;
  messages.push_back(judged.where + "with the E' of " + judged.soft->material + " that is a K_Ic of " +
                     formatShort(1e-6 * K) + " MPa m^0.5" +
                     (weak ? ", less than of any stiff solid (ice 0.1)" : "") + ", and bonds break within " +
                     formatShort(1e9 * zone) + " nm of the front, " +
                     (zone < atom ? "less than an atom's distance"
                                  : formatShort(zone / judged.state.mesh.smallestSpacing()) + " cells") +
                     "; if it is a K_Ic of " + formatShort(judged.atRest) + " MPa m^0.5, write " +
                     formatShort(asK) + " J/m2" + judged.advice());
}

/// Compares the strain and the plastic zone with which a crack runs with what a linear law and K bear.
template <int D>
void judgeZones(const JudgedToughness<D>& judged, std::vector<std::string>& messages)
{
  constexpr double mostStrain = 0.05;
  const BodyMeasure<D>& soft = *judged.soft;
  const std::string crack = "a crack of " + readableLength(judged.crack);
  // A linear law is off by as much as the strain over the crack at which it runs.
  const double strain = judged.griffith(soft, judged.atRest) / soft.moduli.effectiveModulus;
  if (soft.linear && strain > mostStrain)
    messages.push_back(judged.where + crack + " needs a strain of " + formatShort(100.0 * strain) + " % in " +
                       soft.material + ", too much for a linear law" + judged.advice());
  for (const BodyMeasure<D>& body : judged.bodies)
  {
    if (!(body.yield > 0.0))
      continue;
    const double K = std::sqrt(body.moduli.effectiveModulus * judged.atRest);
    const double zone = plasticZone(K, body, judged.state.method.plane);
    const double across = shortestAcrossFronts(judged.state, body);
    if (zone <= smallZone * std::min(judged.crack, across))
      continue;
    messages.push_back(judged.where + crack + " in " + body.material + " runs when some " +
                       readableLength(2.0 * zone) +
                       " ahead of it yield (twice Irwin's radius) at Materials > " + body.material +
                       " > Yield Stress = " + formatReal(body.yield) + " Pa, more than a fifth of " +
                       (judged.crack < across ? "its length" : "the body's " + readableLength(across)) +
                       "; K and the growth criterion assume small-scale yielding" + judged.advice());
    return;
  }
}

/// Compares the loads' stress with that of Griffith, sqrt(E' Gc / (pi a)). Margins are wide, as the loads'
/// stress is nominal. \param others whether loads of unknown stress act
template <int D>
void compareLoads(const JudgedToughness<D>& judged, const std::vector<LoadEstimate>& loads, bool others,
                  std::vector<std::string>& messages)
{
  constexpr double margin = 8.0;
  double highest = 0.0;
  for (const LoadEstimate& load : loads)
    highest = std::max(highest, load.highest);
  const LoadEstimate* load = largestStrain(loads);
  const double needed = judged.griffith(*judged.soft, judged.atRest);
  if (!others && highest > 0.0 && highest * margin < needed)
    messages.push_back(judged.where + "a crack of " + readableLength(judged.crack) +
                       " runs at a stress of about " + formatShort(needed) + " Pa (sqrt(E' Gc / (pi a))), " +
                       formatShort(needed / highest) + " times the highest stress of the loads" +
                       judged.advice());
  if (load != nullptr && load->stress > margin * judged.griffith(*judged.stiff, judged.most))
  {
    const double length =
        judged.stiff->moduli.effectiveModulus * judged.most / (judged.pi * load->stress * load->stress);
    messages.push_back(judged.where + "under the " + formatShort(load->stress) + " Pa of " + load->where +
                       " a flaw of " + readableLength(length) + " would run (E' Gc / (pi sigma^2), " +
                       formatShort(length / judged.state.mesh.smallestSpacing()) + " cells)" +
                       judged.advice());
  }
}

/// A body that its own weight would break, in a scene without gravity: its lengths are hardly meant in
/// metres.
template <int D>
void compareWeight(const JudgedToughness<D>& judged, std::vector<std::string>& messages)
{
  constexpr double g = 9.81;
  for (const BodyMeasure<D>& body : judged.bodies)
  {
    const double weight = body.density * g * body.longest, needed = judged.griffith(body, judged.most);
    if (weight <= needed)
      continue;
    messages.push_back(judged.where + "a crack of " + readableLength(judged.crack) +
                       " runs at a stress of about " + formatShort(needed) +
                       " Pa (sqrt(E' Gc / (pi a))), but the weight of Bodies > " + body.name + ", which is " +
                       readableLength(body.longest) + " long, would stress it with " + formatShort(weight) +
                       " Pa, and the scene has no gravity: are lengths in metres?");
    return;
  }
}

/// Whether a scene has gravity. \param scene its core
inline bool hasGravity(const Teuchos::ParameterList& scene)
{
  if (!scene.isSublist("Boundaries"))
    return false;
  const Teuchos::ParameterList& boundaries = scene.sublist("Boundaries");
  const std::vector<std::string> names = sublistNames(boundaries);
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& name)
                     { return boundaries.sublist(name).template get<std::string>("Type") == "Gravity"; });
}

/// Compares the toughness with bonds, the law and the loads. \param scene its core \param run what other
/// effects declare
template <int D>
void judgeToughness(const Teuchos::ParameterList& scene, const RunOptions& run, const Options& options,
                    State<D>& state)
{
  if (state.cracks.cracks.empty() || state.bodies.info.empty() || !(longestCrack(state) > 0.0))
    return;
  judgeSpeedLimit(scene, options, state);
  const JudgedToughness<D> judged(options, state);
  judgeBonds(judged, state.warnings);
  judgeZones(judged, state.warnings);
  if (!hasGravity(scene))
    compareWeight(judged, state.warnings);
  if (options.equilibrium && run.loadFactor) // which is found
    return;
  const double end = scene.sublist("Time").get<double>("Final Time");
  std::vector<LoadEstimate> loads = estimateLoads(scene, state, judged.bodies);
  const std::vector<LoadEstimate> inCracks = estimatePressures(run.facePressures, end, judged.bodies);
  loads.insert(loads.end(), inCracks.begin(), inCracks.end());
  compareLoads(judged, loads, run.heat() || run.burning, state.warnings);
}

} // namespace Rhegma::propagation
