/// Gas that flows from one crack into another.

#include "combustion/GasExchange.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace Rhegma::combustion
{
namespace
{

GasLaw law(double covolume = 0.0)
{
  GasLaw l;
  l.constant = 320.0;
  l.heatRatio = 1.25;
  l.covolume = covolume;
  l.flameTemperature = 2500.0;
  return l;
}

Gas filled(const GasLaw& l, double pressure, double temperature, double volume)
{
  Gas gas(l);
  gas.fill(pressure, temperature, volume);
  return gas;
}

/// Two gases, and their sums before they met.
struct Pair
{
  Gas one, two;
  double volumeOne, volumeTwo;
  double mass = one.mass() + two.mass(), energy = one.energy() + two.energy();

  void flow(double area, double time) { exchange(one, volumeOne, two, volumeTwo, area, time); }
  double pressureOne() const { return one.pressure(volumeOne); }
  double pressureTwo() const { return two.pressure(volumeTwo); }
  void expectKept() const
  {
    EXPECT_NEAR(one.mass() + two.mass(), mass, 1e-12 * mass);
    EXPECT_NEAR(one.energy() + two.energy(), energy, 1e-12 * energy);
    EXPECT_NEAR(one.passed() + two.passed(), 0.0, 1e-12 * mass);
    EXPECT_NEAR(one.passedEnergy() + two.passedEnergy(), 0.0, 1e-12 * energy);
  }
};

} // namespace

/// The pressure follows from the energy of both, p = (gamma - 1) U / (V - b m). What stays in the first has
/// expanded by its isentrope, T p^((1 - gamma) / gamma); the rest of mass and energy is in the second.
TEST(GasExchange, ComesToOnePressure)
{
  for (const double covolume : {0.0, 1e-3})
    for (const bool turned : {false, true})
    {
      const GasLaw l = law(covolume);
      Pair pair{filled(l, 5e7, 2500.0, 1e-6), filled(l, 1e6, 600.0, 3e-6), 1e-6, 3e-6};
      if (turned)
        pair = {pair.two, pair.one, pair.volumeTwo, pair.volumeOne};
      pair.flow(1e-7, 1.0);
      pair.expectKept();
      const double end = 0.25 * pair.energy / (4e-6 - covolume * pair.mass);
      EXPECT_NEAR(pair.pressureOne(), end, 1e-12 * end);
      EXPECT_NEAR(pair.pressureTwo(), end, 1e-12 * end);
      const Gas& gave = turned ? pair.two : pair.one;
      const double left = 2500.0 * std::pow(end / 5e7, 0.2);
      std::cout << "temperature of the gas that is left over that of its isentrope less 1: "
                << gave.temperature() / left - 1.0 << "\n";
      // Steps of a twentieth of what is left, by their middle: errors of its square.
      EXPECT_NEAR(gave.temperature(), left, 1e-3 * (2500.0 - left));
    }
}

/// A cavity that empties through a choked opening: dm/dt goes as m^((gamma + 1) / 2), so that
/// m / m0 = (1 + (gamma - 1) / 2 q t / m0)^(-2 / (gamma - 1)), q the flow at the start.
TEST(GasExchange, FlowsChokedByTheClosedForm)
{
  const GasLaw l = law();
  Pair pair{filled(l, 5e6, 2500.0, 1e-6), filled(l, 1e5, 300.0, 1e-4), 1e-6, 1e-4};
  const double start = pair.one.mass(), flow = pair.one.outflow(1e-7, 1e-6, 0.0), time = start / flow;
  pair.flow(1e-7, time);
  const double exact = start * std::pow(1.0 + 0.125, -8.0);
  ASSERT_LT(pair.pressureTwo(), 0.5 * pair.pressureOne());
  std::cout << "mass left over the closed form less 1: " << pair.one.mass() / exact - 1.0 << "\n";
  EXPECT_NEAR(pair.one.mass(), exact, 1e-3 * exact);
  pair.expectKept();
}

/// Near one pressure the flow goes as the root of the difference, which so is (1 - t / t_end)^2 of what it
/// was, t_end = 2 x / q for what must flow, x = V_1 V_2 dp / (gamma R T (V_1 + V_2)), and the flow q at the
/// start.
TEST(GasExchange, EndsInAFiniteTime)
{
  const GasLaw l = law();
  const double difference = 1e-4 * 1e6;
  for (const double fraction : {0.25, 0.5, 1.0, 2.0, 1e6})
  {
    Pair pair{filled(l, 1e6 + difference, 2500.0, 1e-6), filled(l, 1e6, 2500.0, 2e-6), 1e-6, 2e-6};
    const double all = 2e-12 / 3e-6 * difference / (1.25 * 320.0 * 2500.0);
    const double flow = 1e-7 * std::sqrt(2.0 * 1e6 / (320.0 * 2500.0) * difference);
    pair.flow(1e-7, fraction * 2.0 * all / flow);
    const double left = std::max(1.0 - fraction, 0.0);
    // To first order in the difference over the pressure.
    EXPECT_NEAR(pair.pressureOne() - pair.pressureTwo(), left * left * difference, 1e-3 * difference);
  }
}

/// In one step as in many, also into a volume that is a millionth of the other: no more than makes the
/// pressures equal, and no oscillation about that.
TEST(GasExchange, IsStableInASmallVolume)
{
  const GasLaw l = law();
  for (const double small : {1e-12, 1e-9, 1e-6})
  {
    Pair pair{filled(l, 2e6, 2500.0, 1e-6), filled(l, 1e5, 300.0, small), 1e-6, small};
    const double all = 0.25 * pair.energy / (1e-6 + small);
    for (int k = 0; k < 10; ++k)
    {
      pair.flow(1e-5, 1e-3);
      EXPECT_NEAR(pair.pressureOne(), pair.pressureTwo(), 1e-9 * 2e6);
      EXPECT_NEAR(pair.pressureOne(), all, 1e-9 * 2e6);
    }
    pair.expectKept();
  }
}

TEST(GasExchange, DoesNotFlowBetweenEqualPressures)
{
  const GasLaw l = law(1e-3);
  Pair pair{filled(l, 2e6, 2500.0, 1e-6), filled(l, 2e6, 2500.0, 1e-6), 1e-6, 1e-6};
  pair.flow(1e-5, 1.0);
  EXPECT_EQ(pair.one.passed(), 0.0);
  EXPECT_EQ(pair.two.passedEnergy(), 0.0);
  Pair closed{filled(l, 2e6, 2500.0, 1e-6), filled(l, 1e6, 2500.0, 1e-6), 1e-6, 1e-6};
  closed.flow(0.0, 1.0);
  EXPECT_EQ(closed.one.passed(), 0.0);
}

/// Walls that keep both gases at one temperature: p = m R T / V of both together.
TEST(GasExchange, ComesToOnePressureAtConstantTemperature)
{
  GasLaw l = law();
  l.constantTemperature = true;
  Pair pair{filled(l, 2e6, 2500.0, 1e-6), filled(l, 1e5, 2500.0, 3e-6), 1e-6, 3e-6};
  for (int k = 0; k < 20; ++k)
    pair.flow(1e-5, 1e-3);
  const double end = pair.mass * 320.0 * 2500.0 / 4e-6;
  EXPECT_NEAR(pair.pressureOne(), end, 1e-9 * end);
  EXPECT_NEAR(pair.pressureTwo(), end, 1e-9 * end);
  EXPECT_NEAR(pair.one.mass() + pair.two.mass(), pair.mass, 1e-12 * pair.mass);
  for (const Gas* gas : {&pair.one, &pair.two})
    EXPECT_NEAR(gas->energy() + gas->wallHeat(), gas->startEnergy() + gas->passedEnergy(),
                1e-12 * pair.energy);
}

/// Walls of two temperatures: what passes comes to that of the other side, so that the mass that must flow is
/// not that of its enthalpy. However long it may, the flow ends where the pressures are equal.
TEST(GasExchange, ComesToOnePressureBetweenWallsOfTwoTemperaturesInOneCall)
{
  for (const double covolume : {0.0, 1e-3})
    for (const bool hotter : {false, true})
    {
      GasLaw one = law(covolume), two = law(covolume);
      one.constantTemperature = two.constantTemperature = true;
      one.flameTemperature = hotter ? 6000.0 : 300.0;
      two.flameTemperature = hotter ? 300.0 : 6000.0;
      Pair pair{filled(one, 2e6, one.flameTemperature, 1e-6), filled(two, 1e5, two.flameTemperature, 3e-6),
                1e-6, 3e-6};
      pair.flow(1e-5, 1.0);
      EXPECT_NEAR(pair.pressureOne(), pair.pressureTwo(), 1e-9 * pair.pressureOne())
          << "covolume " << covolume << ", from " << one.flameTemperature << " K";
      EXPECT_NEAR(pair.one.mass() + pair.two.mass(), pair.mass, 1e-12 * pair.mass);
    }
}

TEST(GasExchange, MixesAlikeGasesOnly)
{
  GasLaw one = law(), two = law();
  two.flameTemperature = 2000.0;
  EXPECT_TRUE(mixes(one, two));
  two.covolume = 1e-3;
  EXPECT_FALSE(mixes(one, two));
  one.covolume = 1e-3;
  one.heatRatio = 1.3;
  EXPECT_FALSE(mixes(one, two));
}

} // namespace Rhegma::combustion
