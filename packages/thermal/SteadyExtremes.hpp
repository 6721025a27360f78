#pragma once
/// Steady temperatures that no solid has.

#include "base/ShortNumber.hpp"
#include "thermal/Conduction.hpp"

#include <cmath>
#include <limits>
#include <string>

namespace Rhegma::thermal
{

/// Above the highest melting point of all solids, that of hafnium carbonitride (some 4300 K).
constexpr double noSolidAbove = 4500.0; // [K]

/// Linear thermal strain beyond that of solids, most of which melt at 0.02.
constexpr double noSolidStrain = 0.05;

/// Thermal stretch of a particle at its temperature.
template <int D>
double stretchOf(const State<D>& state, int particle)
{
  const ThermoTables tables = state.materials.thermo;
  const auto material = state.particles.integer(fields::material);
  const auto T = state.particles.scalar(fields::temperature);
  double theta = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::thermal::stretchOf", Kokkos::RangePolicy<ExecSpace>(particle, particle + 1),
      KOKKOS_LAMBDA(const int p, double& sum) { sum += ThermoPoint(tables, material(p), T(p)).stretch(); },
      theta);
  return theta;
}

/// Why steady temperatures leave nothing to solve for: they are not above absolute zero, or above all melting
/// points with a thermal strain of no solid. Empty otherwise, and on ranks without the particle that is
/// coldest or hottest of all. Collective.
/// \return the body, its temperature and thermal strain, and the sections that determine them
template <int D>
std::string failureOfSteady(const State<D>& state, const Conduction<D>& conduction)
{
  const auto T = onHost(state.particles.scalar(fields::temperature));
  int coldest = 0, hottest = 0;
  for (int p = 0; p < state.particles.size(); ++p)
  {
    coldest = T(p) < T(coldest) ? p : coldest;
    hottest = T(p) > T(hottest) ? p : hottest;
  }
  const bool any = state.particles.size() > 0;
  constexpr double none = std::numeric_limits<double>::lowest();
  const double own[] = {any ? -T(coldest) : none, any ? T(hottest) : none};
  double most[] = {own[0], own[1]};
  state.ranks.max(most, 2);
  const bool cold = !(-most[0] > 0.0);
  if (!any || (cold ? own[0] < most[0] : own[1] < most[1]))
    return {};
  const int at = cold ? coldest : hottest;
  const double theta = stretchOf(state, at);
  const double strain = theta - 1.0;
  if (!cold && !(T(at) > noSolidAbove && std::fabs(strain) > noSolidStrain))
    return {};
  const auto body = onHost(state.particles.integer(fields::body));
  std::string where = conduction.boundaries.asText();
  for (const Source<D>& source : conduction.sources)
    where += (where.empty() ? "" : ", ") + ("Thermal > Sources > " + source.name);
  return "steady conduction: Bodies > " + state.bodies.info[body(at)].name + " comes to " +
         formatShort(T(at)) + " K" +
         (cold ? ", and temperatures are absolute"
               : ", at which no solid exists, with a thermal strain of " + formatShort(100.0 * strain) +
                     " %") +
         "; check " + where;
}

} // namespace Rhegma::thermal
