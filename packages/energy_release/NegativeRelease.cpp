#include "energy_release/NegativeRelease.hpp"

#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "plausibility/CrackExtent.hpp"
#include "state/Subdomain.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::energy_release
{

namespace
{

/// Of all bodies, undeformed [m3].
template <int D>
double volumeOf(const State<D>& state)
{
  const auto volume = state.particles.scalar(fields::volume);
  double all = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::volumeOfBodies", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p, double& sum) { sum += volume(p); }, all);
  sumParts(state, &all, 1);
  return all;
}

} // namespace

template <int D>
double usualRelease(const State<D>& state, int crack)
{
  constexpr double pi = 3.14159265358979;
  const double extent = extentOf(state, crack), strain = state.energy.strain;
  const double inPlate = 2.0 * pi * strain / volumeOf(state) * extent;
  const double inArms = strain / areaOf(state, crack);
  return extent > 0.0 ? std::min(inPlate, inArms) : 0.0;
}

template <int D>
std::vector<std::string> warningsOfNegativeRelease(const State<D>& state,
                                                   const std::vector<FrontSample<D>>& samples, double time,
                                                   double largestEver)
{
  constexpr double noise = 0.05;
  std::vector<std::string> warnings;
  double largest = largestEver, least = 0.0;
  for (const FrontSample<D>& sample : samples)
  {
    const double release = meanAlong(sample.front, sample.J);
    largest = std::max(largest, std::isfinite(release) ? release : 0.0);
    least = std::min(least, std::isfinite(release) ? release : 0.0);
  }
  if (least >= -noise * largest) // without a look at all particles
    return warnings;
  for (const FrontSample<D>& sample : samples)
  {
    const double release = meanAlong(sample.front, sample.J);
    if (release < -noise * std::max(largest, usualRelease(state, sample.front.crack)))
      warnings.push_back("Energy Release: G_J of " + frontName(state.cracks, sample.front) + " is " +
                         formatShort(release) + " J/m2 at t = " + readableTime(time) +
                         ", but no crack without tractions has a negative one: the domain integral from " +
                         readableLength(sample.tube.radii.inner) + " to " +
                         readableLength(sample.tube.radii.outer) +
                         " meets a face, a surface or a load, or the cells do not resolve what is around the "
                         "front; do not use G_J and K of this front: use smaller cells (Domain > Cell Size)");
  }
  return warnings;
}

template double usualRelease(const State<2>&, int);
template double usualRelease(const State<3>&, int);
template std::vector<std::string>
warningsOfNegativeRelease(const State<2>&, const std::vector<FrontSample<2>>&, double, double);
template std::vector<std::string>
warningsOfNegativeRelease(const State<3>&, const std::vector<FrontSample<3>>&, double, double);

} // namespace Rhegma::energy_release
