#pragma once
/// Whether the numbers of burning are those of a burning solid
/// (docs/reference/warnings-of-cracks-and-runs.md).

#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "combustion/Burning.hpp"
#include "geometry/NearestPoint.hpp"
#include "plausibility/CrackExtent.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::combustion
{

/// Warns of a gas and a flame that do not exist. Hydrogen has the largest gas constant, 4124 J/(kg K),
/// uranium hexafluoride one of the smallest, 24 J/(kg K); the hottest flame, of dicyanoacetylene, has 5260 K,
/// cool flames 500 K.
inline void judgeGas(const std::string& where, const Teuchos::ParameterList& list,
                     std::vector<std::string>& warnings)
{
  constexpr double leastConstant = 15.0, mostConstant = 4200.0, coldest = 400.0, hottest = 6000.0;
  const double R = list.get<double>("Gas Constant"), flame = list.get<double>("Flame Temperature");
  if (R < leastConstant || R > mostConstant)
    warnings.push_back(
        where + " > Gas Constant is " + formatShort(R) + " J/(kg K), " +
        (R > mostConstant ? "more than that of hydrogen (4124)" : "less than that of any gas (24)") +
        "; it is the universal 8.314 J/(mol K) over the molar mass in kg/mol, such as 287 of air");
  if (flame < coldest || flame > hottest)
    warnings.push_back(
        where + " > Flame Temperature is " + formatShort(flame) + " K, " +
        (flame > hottest ? "hotter than any flame (5300 K)" : "colder than any flame (500 K)") +
        "; it is absolute, in kelvin, and at constant volume");
  if (!list.isParameter("Ignition Temperature"))
    return;
  if (const double ignition = list.get<double>("Ignition Temperature"); ignition >= flame)
    warnings.push_back(where + " > Ignition Temperature is " + formatShort(ignition) +
                       " K, and its Flame Temperature only " + formatShort(flame) +
                       " K, so the flame does not ignite other faces; both are in kelvin");
}

/// Warns of faces that recede faster than any flame, past all of their body, or by less than an atom.
/// \param pressure at the start [Pa] \param duration of burning [s]
template <int D>
void judgeRate(const std::string& where, const BurnRate& rate, double pressure, double duration,
               const std::vector<BodyMeasure<D>>& bodies, std::vector<std::string>& warnings)
{
  // Propellants have up to 0.1 m/s at 10 MPa, the fastest explosives some 10 m/s at 1 GPa; a solid that does
  // not burn by less than 1e-10 m at 1 GPa does not at all.
  constexpr double fastest = 10.0, high = 1e9, atom = 1e-10;
  const auto largest = std::max_element(bodies.begin(), bodies.end(),
                                        [](const auto& a, const auto& b) { return a.shortest < b.shortest; });
  const double now = rate(pressure), most = rate(std::max(pressure, high));
  const std::string units = "; rates are in m/s and pressures in Pa: multiply a coefficient in mm/s/MPa^n "
                            "by 1e-3 / 1e6^n";
  if (now > fastest)
    warnings.push_back(where + ": its faces burn at " + formatShort(now) +
                       " m/s at the initial pressure of " + formatShort(pressure) +
                       " Pa, faster than any solid (some 10 m/s at 1 GPa)" + units);
  else if (largest != bodies.end() && now * duration > largest->shortest)
    warnings.push_back(where + ": at its initial pressure alone its faces recede by " +
                       readableLength(now * duration) + " up to Time > Final Time (" + formatShort(now) +
                       " m/s), through all of Bodies > " + largest->name + ", " +
                       readableLength(largest->shortest) + " thick" + units);
  else if (most > 0.0 && most * duration < atom)
    warnings.push_back(where + ": even at 1 GPa its faces recede by only " + readableLength(most * duration) +
                       " up to Time > Final Time (" + formatShort(most) + " m/s), less than an atom" + units);
}

/// Points all over a crack, at most half a cell apart along two edges of its simplices [m]. \param cell [m]
template <int D>
std::vector<Vector<D>> pointsOf(const CrackSet<D>& cracks, int crack, double cell)
{
  const auto vertex = onHost(cracks.vertex);
  const auto simplex = onHost(cracks.simplex);
  const Crack<D>& own = cracks.cracks[crack];
  std::vector<Vector<D>> points;
  for (int s = own.firstSimplex; s < own.firstSimplex + own.numSimplices; ++s)
  {
    Vector<D> corner[D], along[D];
    double longest = 0.0;
    for (int k = 0; k < D; ++k)
    {
      for (int d = 0; d < D; ++d)
        corner[k][d] = vertex(simplex(s, k), d);
      along[k] = corner[k] - corner[0];
      longest = std::max(longest, norm(along[k]));
    }
    const int cuts = std::max(1, static_cast<int>(std::ceil(2.0 * longest / cell)));
    for (int i = 0; i <= cuts; ++i)
      for (int j = 0; j <= (D == 3 ? cuts - i : 0); ++j)
        points.push_back(corner[0] + (1.0 * i / cuts) * along[1] + (1.0 * j / cuts) * along[D - 1]);
  }
  return points;
}

/// Warns of faces that are hotter at the start than their ignition temperature, as where a body has a
/// temperature of its own.
template <int D>
void judgeIgnition(const State<D>& state, const Burning<D>& burning, const std::string& where,
                   std::vector<std::string>& warnings)
{
  if (!burning.ignition.byTemperature() || state.materials.thermo.empty())
    return;
  const double cell = state.mesh.grid.spacing;
  const std::vector<Vector<D>> points = pointsOf(state.cracks, burning.crack, cell);
  const NearestPoint<D> near(points, cell);
  const auto position = onHost(state.particles.template real<D>(fields::position));
  const auto temperature = onHost(state.particles.scalar(fields::temperature));
  double hottest = 0.0;
  for (int p = 0; p < state.particles.size(); ++p)
  {
    Vector<D> x;
    for (int d = 0; d < D; ++d)
      x[d] = position(p, d);
    if (temperature(p) > hottest && near.find(x) >= 0)
      hottest = temperature(p);
  }
  if (hottest < burning.ignition.temperature)
    return;
  warnings.push_back(
      where + " > Ignition Temperature is " + formatShort(burning.ignition.temperature) +
      " K, and its faces have up to " + formatShort(hottest) + " K at the start, so that they burn " +
      (burning.ignition.time > 0.0 ? "from Ignition Time = " + readableTime(burning.ignition.time) + " on"
                                   : std::string("at once")) +
      "; write a higher one or colder bodies (kelvin), or leave it out if that is meant");
}

/// Warns of what burns in one crack. \param list its parameters \param end of the run [s]
template <int D>
void judgeBurning(const State<D>& state, const Burning<D>& burning, const Teuchos::ParameterList& list,
                  double end, std::vector<std::string>& warnings)
{
  const std::string where = "Combustion > " + state.cracks.cracks[burning.crack].name;
  judgeGas(where, list, warnings);
  judgeIgnition(state, burning, where, warnings);
  const double duration = std::max(0.0, end - list.get<double>("Ignition Time"));
  if (duration == 0.0)
    warnings.push_back(where + " > Ignition Time is " + readableTime(list.get<double>("Ignition Time")) +
                       ", after Time > Final Time = " + readableTime(end) + ", so nothing burns");
  else
    judgeRate(where, burning.rate, burning.startPressure, duration, crackedBodies(state), warnings);
}

} // namespace Rhegma::combustion
