/// The gas alone: its state, its flow, and the law of burning.

#include "Seed.hpp"
#include "combustion/BurnRate.hpp"
#include "combustion/Gas.hpp"
#include "combustion/Ignition.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

namespace Rhegma::combustion
{
namespace
{

GasLaw law()
{
  GasLaw l;
  l.constant = 320.0;
  l.heatRatio = 1.25;
  l.flameTemperature = 2500.0;
  return l;
}

/// What flows from rest to a pressure by an isentrope that is integrated: c_v dT = - p dv in steps of Runge
/// and Kutta, and u^2 = 2 (h0 - h).
struct Expansion
{
  double speed;   ///< at the end [m/s]
  double largest; ///< flux during the expansion or at its end [kg/(m2 s)]
};
Expansion expand(const GasLaw& l, double pressure, double temperature, double outside)
{
  const double fraction = l.heatRatio - 1.0;
  double v = l.constant * temperature / pressure + l.covolume, e = l.heatCapacity() * temperature;
  const double rest = e + pressure * v;
  const auto pressureAt = [&](double energy, double volume)
  { return fraction * energy / (volume - l.covolume); };
  const auto after = [&](double dv)
  {
    const double a = -pressureAt(e, v), b = -pressureAt(e + 0.5 * dv * a, v + 0.5 * dv),
                 c = -pressureAt(e + 0.5 * dv * b, v + 0.5 * dv), d = -pressureAt(e + dv * c, v + dv);
    return e + dv / 6.0 * (a + 2.0 * b + 2.0 * c + d);
  };
  Expansion found{0.0, 0.0};
  const double end = std::max(outside, 0.2 * pressure); // far beyond where it is choked
  for (bool last = false; !last;)
  {
    double dv = 1e-4 * (v - l.covolume);
    last = pressureAt(after(dv), v + dv) < end;
    for (double low = 0.0, high = dv; last && high - low > 1e-14 * v;)
    {
      dv = 0.5 * (low + high);
      (pressureAt(after(dv), v + dv) > end ? low : high) = dv;
    }
    e = after(dv);
    v += dv;
    found.speed = std::sqrt(2.0 * (rest - e - pressureAt(e, v) * v));
    found.largest = std::max(found.largest, found.speed / v);
  }
  return found;
}

TEST(Gas, FillsAVolumeByTheLawOfNobleAndAbel)
{
  GasLaw l = law();
  l.covolume = 1e-3;
  Gas gas(l);
  gas.fill(1e8, 1000.0, 1e-6);
  // p (V - b m) = m R T
  EXPECT_NEAR(1e8 * (1e-6 - 1e-3 * gas.mass()), gas.mass() * 320.0 * 1000.0, 1e-12 * 1e8 * 1e-6);
  EXPECT_NEAR(gas.pressure(1e-6), 1e8, 1e-12 * 1e8);
  EXPECT_NEAR(gas.temperature(), 1000.0, 1e-12 * 1000.0);
}

/// Work p dV and nothing else keeps p V^gamma; the error of 2 n steps is half that of n.
TEST(Gas, ExpandsByTheAdiabat)
{
  const auto endPressure = [](int steps)
  {
    Gas gas(law());
    gas.fill(1e6, 2500.0, 1e-6);
    for (int k = 0; k < steps; ++k)
    {
      const double now = 1e-6 * (1.0 + double(k) / steps), next = 1e-6 * (1.0 + double(k + 1) / steps);
      gas.doWork(gas.pressure(now) * (next - now));
    }
    return gas.pressure(2e-6);
  };
  const double exact = 1e6 * std::pow(2.0, -1.25);
  const double coarse = endPressure(1000) - exact, fine = endPressure(2000) - exact;
  EXPECT_LT(std::fabs(fine), 1e-3 * exact);
  EXPECT_NEAR(fine / coarse, 0.5, 0.01);
}

TEST(Gas, BurnsToTheFlameTemperatureInARigidCavity)
{
  Gas gas(law());
  gas.fill(1e5, 2500.0, 1e-6);
  const double before = gas.mass();
  gas.burn(3.0 * before, 0.0);
  EXPECT_NEAR(gas.temperature(), 2500.0, 1e-10);
  EXPECT_NEAR(gas.pressure(1e-6), 4e5, 1e-9 * 4e5);
}

TEST(Gas, FlowsOutChokedOrAsAnIncompressibleFluid)
{
  Gas gas(law());
  gas.fill(1e6, 2500.0, 1e-6);
  const double k = 1.25, critical = std::sqrt(k) * std::pow(2.0 / (k + 1.0), 0.5 * (k + 1.0) / (k - 1.0));
  const double choked = 1e-6 * 1e6 / std::sqrt(320.0 * 2500.0) * critical;
  EXPECT_NEAR(gas.outflow(1e-6, 1e-6, 0.0), choked, 1e-12 * choked);
  EXPECT_NEAR(gas.outflow(1e-6, 1e-6, 4e5), choked, 1e-12 * choked);
  // A small difference of pressure: A sqrt(2 rho dp), to first order in dp / p.
  const double density = 1e6 / (320.0 * 2500.0), slow = 1e-6 * std::sqrt(2.0 * density * 1e3);
  EXPECT_NEAR(gas.outflow(1e-6, 1e-6, 1e6 - 1e3), slow, 1e-3 * slow);
  EXPECT_EQ(gas.outflow(1e-6, 1e-6, 2e6), 0.0);
  EXPECT_EQ(gas.outflow(0.0, 1e-6, 0.0), 0.0);
}

/// Choked and slower, with a covolume of a fifth of the gas' volume and without: against an isentrope that is
/// integrated. Steps of 1e-4 find the largest flux to the square of that.
TEST(Gas, FlowsOutByTheIsentropeOfNobleAndAbel)
{
  for (const double covolume : {0.0, 1e-3})
    for (const double outside : {0.0, 1e5, 1.0e8, 1.3e8, 1.9e8})
    {
      GasLaw l = law();
      l.covolume = covolume;
      const double p = 2e8, T = 2500.0, area = 2e-6;
      const double flux = area * expand(l, p, T, outside).largest;
      EXPECT_NEAR(l.outflow(area, p, T, outside), flux, 1e-7 * flux) << covolume << ", " << outside;
    }
}

/// Stagnant gas that expands again has its former speed.
TEST(Gas, StagnatesByTheIsentropeOfNobleAndAbel)
{
  for (const double covolume : {0.0, 1e-3})
  {
    GasLaw l = law();
    l.covolume = covolume;
    double p = 1.5e8, T = 2000.0;
    l.stagnate(p, T, 600.0);
    EXPECT_GT(p, 1.5e8);
    EXPECT_NEAR(expand(l, p, T, 1.5e8).speed, 600.0, 1e-7 * 600.0) << covolume;
  }
}

/// What flows out takes c_p T: a cavity that empties adiabatically keeps p / rho^gamma.
TEST(Gas, CoolsAsItEmpties)
{
  Gas gas(law());
  gas.fill(1e6, 2500.0, 1e-6);
  const double before = gas.mass();
  while (gas.mass() > 0.5 * before)
    gas.vent(1e-4 * before, 1e-6);
  const double exact = 1e6 * std::pow(gas.mass() / before, 1.25);
  EXPECT_NEAR(gas.pressure(1e-6), exact, 1e-4 * exact);
}

TEST(Gas, KeepsItsTemperatureWhereTheWallsDo)
{
  GasLaw l = law();
  l.constantTemperature = true;
  Gas gas(l);
  gas.fill(1e6, 2500.0, 1e-6);
  gas.doWork(0.1 * gas.energy());
  gas.settle();
  EXPECT_NEAR(gas.temperature(), 2500.0, 1e-10);
  EXPECT_NEAR(gas.energy() + gas.workDone() + gas.wallHeat(), gas.startEnergy(), 1e-12 * gas.startEnergy());
  EXPECT_LT(gas.wallHeat(), 0.0);
}

TEST(BurnRate, IsVieillesOrATable)
{
  EXPECT_NEAR(BurnRate::vieille(1e-8, 0.9)(1e6), 1e-8 * std::pow(1e6, 0.9), 1e-16);
  EXPECT_EQ(BurnRate::vieille(2e-3, 0.0)(0.0), 2e-3);
  const BurnRate table = BurnRate::table("1e5:1e-3, 1e6:1e-2, 2e6:1e-2");
  EXPECT_EQ(table(0.0), 1e-3);
  EXPECT_NEAR(table(5.5e5), 5.5e-3, 1e-15);
  EXPECT_EQ(table(3e6), 1e-2);
  for (const char* wrong : {"", "1e5", "1e5:1e-3, 1e5:2e-3", "1e5:-1", "1e5:1e-3 2", "a:b"})
    EXPECT_THROW(BurnRate::table(wrong), std::invalid_argument) << wrong;
}

/// PBX 9501 with the constants of Ward, Son and Brewster.
WardSonBrewster explosive()
{
  return {1.637e15, 1.76e5, 1.6e-3, 4e5, 3.018e6, 0.2, 0.07, 1400.0, 0.0342, 298.0, 1840.0};
}

TEST(BurnRate, OfWardSonAndBrewster)
{
  // Solved independently and printed with three digits: half of the last one is 0.5 % at most.
  const double known[][2] = {{0.1e6, 0.335e-3}, {0.5e6, 1.21e-3}, {1e6, 2.15e-3},  {2e6, 3.87e-3},
                             {5e6, 8.44e-3},    {6.9e6, 11.1e-3}, {10e6, 15.3e-3}, {20e6, 27.8e-3},
                             {50e6, 61.1e-3},   {100e6, 110.6e-3}};
  const BurnRate rate = BurnRate::wardSonBrewster(explosive());
  for (const auto& [pressure, value] : known)
    EXPECT_NEAR(rate(pressure), value, 5e-3 * value) << pressure;
  EXPECT_NEAR(burningSurface(explosive(), 0.1e6).temperature, 655.0, 0.5);
  EXPECT_NEAR(burningSurface(explosive(), 100e6).temperature, 1028.0, 0.5);
}

TEST(BurnRate, TableOfWardSonAndBrewsterIsGoodToTenThousandths)
{
  const BurnRate rate = BurnRate::wardSonBrewster(explosive());
  std::mt19937 random(Rhegma::Test::seed());
  for (int k = 0; k < 200; ++k)
  {
    const double pressure = std::pow(10.0, std::uniform_real_distribution<double>(3.0, 10.0)(random));
    const double exact = burningSurface(explosive(), pressure).rate;
    EXPECT_NEAR(rate(pressure), exact, 1e-4 * exact) << pressure;
  }
}

TEST(BurnRate, SurfaceOfWardSonAndBrewsterSolvesItsEquations)
{
  const WardSonBrewster s = explosive();
  for (const double pressure : {1e4, 1e6, 1e9})
  {
    const BurningSurface surface = burningSurface(s, pressure);
    const double m = surface.rate * s.density, R = 8.314462618, T = surface.temperature;
    // The flame stands at a distance x at which the heat of its gas is conducted back to the surface.
    const double x =
        2.0 * s.gasConductivity /
        (std::sqrt(m * m * s.capacity * s.capacity + 4.0 * s.gasConductivity * s.gasPrefactor * s.capacity *
                                                         std::pow(s.molarMass * pressure / R, 2)) -
         m * s.capacity);
    EXPECT_NEAR(T - s.temperature - s.heatOfSolid / s.capacity,
                s.heatOfGas / s.capacity / (1.0 + x * m * s.capacity / s.gasConductivity), 1e-6 * T)
        << pressure;
  }
}

TEST(Flame, SpreadsWithThePressureAndIsQuenchedInNarrowGaps)
{
  Ignition<2> ignition;
  ignition.flameSpeed = 0.259e-2;
  EXPECT_EQ(ignition.speedAt(5e7), 0.259e-2);
  ignition.speedExponent = 0.538;
  EXPECT_NEAR(ignition.speedAt(1e6), 0.259e-2 * std::pow(10.0, 0.538), 1e-12);
  const Quenching law{8e8, 2.84};
  for (const auto& [pressure, opening] :
       {std::pair{1e6, 85.4e-6}, std::pair{1e7, 3.25e-6}, std::pair{1e8, 0.1234e-6}})
  {
    EXPECT_TRUE(law.quenches(0.995 * opening, pressure)) << pressure;
    EXPECT_FALSE(law.quenches(1.005 * opening, pressure)) << pressure;
  }
  EXPECT_FALSE(Quenching{}.quenches(0.0, 1e5));
}

} // namespace
} // namespace Rhegma::combustion
