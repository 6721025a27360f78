#include "energy_release/Disagreement.hpp"

#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "energy_release/FrontDisk.hpp"
#include "energy_release/NegativeRelease.hpp"
#include "material/LawStiffness.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::energy_release
{

namespace
{

/// The front of a sample as it is now: a sample of a checkpoint has no temperature.
const CrackFront<2>& frontNow(const State<2>& state, const CrackFront<2>& front)
{
  for (const CrackFront<2>& one : state.cracks.fronts)
    if (one.crack == front.crack && one.number == front.number)
      return one;
  return front;
}

/// G of the intensities [J/m2]; not a number in a material without K.
double releaseOfIntensities(const State<2>& state, const FrontSample<2>& sample)
{
  const CrackFront<2>& front = frontNow(state, sample.front);
  if (!isLinear(lawAtFront(state, front)))
    return FrontSample<2>::notYet;
  return complianceAtFront(state, front).release(sample.modeI[0], sample.modeII[0]);
}

std::string reasonOf(const State<2>& state, const FrontSample<2>& sample)
{
  if (frontNow(state, sample.front).grown)
    return state.method.equilibrium()
               ? "the front has grown, and its cells are coarse where it is now: do not use K of this front"
               : "the front has grown, and waves and the cohesive traction on its new faces disturb K more "
                 "than G_J: do not use K of this front";
  return "at least one of them is wrong by half of this or more, because the domain integral from " +
         readableLength(sample.tube.radii.inner) + " to " + readableLength(sample.tube.radii.outer) +
         " has few cells or is next to a surface, a load or another crack: use smaller cells (Domain > Cell "
         "Size), and compare with --twice";
}

} // namespace

bool disagrees(const State<3>&, const FrontSample<3>&) { return false; }

bool disagrees(const State<2>& state, const FrontSample<2>& sample)
{
  constexpr double most = 0.1; // of G: 5 % of K
  return !sample.J.empty() && !sample.modeI.empty() &&
         std::fabs(releaseOfIntensities(state, sample) - sample.J[0]) > most * std::fabs(sample.J[0]);
}

template <>
std::vector<std::string> warningsOfDisagreement(const State<3>&, const std::vector<FrontSample<3>>&, double)
{
  return {};
}

template <>
std::vector<std::string> warningsOfDisagreement(const State<2>& state,
                                                const std::vector<FrontSample<2>>& samples, double time)
{
  constexpr double small = 0.05; // of the largest G, and of the usual one: less is noise
  double largest = 0.0;
  for (const FrontSample<2>& sample : samples)
    if (!sample.J.empty() && std::isfinite(sample.J[0]))
      largest = std::max(largest, sample.J[0]);
  std::vector<std::string> warnings;
  // Waves that pass a front disturb K and G in different ways: only what is nearly at rest is compared.
  constexpr double moving = 0.1; // kinetic over strain energy
  if (state.energy.kinetic > moving * state.energy.strain)
    return warnings;
  for (const FrontSample<2>& sample : samples)
  {
    if (sample.front.ended || sample.front.speed() > 0.0 || sample.J.empty() || sample.modeI.empty())
      continue;
    const double J = sample.J[0], release = releaseOfIntensities(state, sample),
                 larger = std::max(J, release);
    if (!disagrees(state, sample) || !(larger > small * largest) ||
        !(larger > small * usualRelease(state, sample.front.crack)))
      continue;
    warnings.push_back(
        "Energy Release: K_I and K_II of " + frontName(state.cracks, sample.front) +
        " at t = " + readableTime(time) + (sample.isotropic ? " give G = K^2 / E' = " : " give G = ") +
        formatShort(release) + " J/m2, " +
        formatShort(std::round(100.0 * std::fabs(release / std::max(std::fabs(J), 1e-9 * larger) - 1.0))) +
        " % " + (release > J ? "more" : "less") + " than the " + formatShort(J) +
        " J/m2 of G_J: " + reasonOf(state, sample));
  }
  return warnings;
}

} // namespace Rhegma::energy_release
