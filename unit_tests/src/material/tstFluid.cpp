/// The law of fluids: adiabates, energy, viscosity, speed of sound, and what it refuses.

#include "Cases.hpp"
#include "Seed.hpp"
#include "material/Fluid.hpp"
#include "material/MaterialReader.hpp"

namespace Rhegma
{
namespace Test
{

namespace
{

constexpr double airPressure = 1.0e5, gamma = 1.4, airDensity = 1.2;
constexpr double waterBulk = 2.2e9, waterExponent = 7.15, waterDensity = 1000.0;

Teuchos::ParameterList air()
{
  Teuchos::ParameterList list;
  list.set("Model", "Fluid");
  list.set("Density", airDensity);
  list.set("Equation Of State", "Ideal Gas");
  list.set("Initial Pressure", airPressure);
  list.set("Heat Capacity Ratio", gamma);
  list.set("Linear Viscosity", 0.0);
  list.set("Quadratic Viscosity", 0.0);
  return list;
}

Teuchos::ParameterList water()
{
  Teuchos::ParameterList list;
  list.set("Model", "Fluid");
  list.set("Density", waterDensity);
  list.set("Equation Of State", "Tait");
  list.set("Bulk Modulus", waterBulk);
  list.set("Tait Exponent", waterExponent);
  list.set("Linear Viscosity", 0.0);
  list.set("Quadratic Viscosity", 0.0);
  return list;
}

template <int D>
Properties fluid(const Teuchos::ParameterList& list)
{
  Properties m = readMaterial<LawList<Fluid>>(list, "Test", D == 2 ? Plane::Strain : Plane::Solid);
  m.cellSize = 0.01;
  return m;
}

/// A fluid particle along a path.
template <int D>
struct Particle
{
  static constexpr Plane P = D == 2 ? Plane::Strain : Plane::Solid;
  Properties m;
  Gradient<D> F = identity<D>();
  std::array<double, Fluid::historySize<D>> history{};
  Symmetric<D> tau{};

  explicit Particle(const Teuchos::ParameterList& list) : m(fluid<D>(list)) { to(F, 0.0); }

  void to(Gradient<D> next, double dt)
  {
    const Gradient<D> before = F;
    F = next;
    const LawStep step{before.data(), dt, m.temperature};
    ASSERT_TRUE((Fluid::stress<D, P>(step, m, F.data(), tau.data(), history.data())));
  }
  double volume() const { return determinant<D>(F.data()); }
  /// Mean pressure, viscous parts included [Pa].
  double pressure() const { return -trace<D>(tau.data()) / (3.0 * volume()); }
  double energy() const { return Fluid::energy<D, P>(m, F.data(), history.data()); }
  double speed() const { return Fluid::waveSpeed<D, P>(m, F.data(), history.data()); }
  double dissipated() const { return history[Fluid::dissipationIndex<D>]; }
};

/// Of the volume ratio J, in any shape.
template <int D>
Gradient<D> shapeOf(double J, Random& random)
{
  Gradient<D> F = random.deformation<D>(0.7, 1.4);
  if (D == 2)
    F[gradientSize<D> - 1] = 1.0;
  const double scale = std::pow(J / determinant<D>(F.data()), 1.0 / D);
  for (int k = 0; k < D * D; ++k)
    F[k] *= scale;
  return F;
}

class DrawFluid
{
public:
  double between(double low, double high) { return low + (high - low) * unit_(engine_); }

private:
  std::mt19937 engine_{seed()};
  std::uniform_real_distribution<double> unit_{0.0, 1.0};
};

/// p = p0 J^-gamma and E = p0 / (gamma - 1) (J^(1 - gamma) - 1), however the gas came there: each step
/// rounds.
template <int D>
void checkAdiabate()
{
  DrawFluid draw;
  Random random;
  for (int path = 0; path < 20; ++path)
  {
    Particle<D> gas(air());
    const double ratio = path == 0 ? 0.5 : draw.between(0.2, 4.0);
    const int steps = 1 + static_cast<int>(draw.between(0.0, 300.0));
    for (int k = 1; k <= steps; ++k)
    {
      const double J = k == steps ? ratio : draw.between(0.2, 4.0);
      gas.to(shapeOf<D>(J, random), draw.between(1e-7, 1e-3));
    }
    const double rounding = 1e-15 * (steps + 10) * 10.0;
    EXPECT_NEAR(gas.pressure() / (airPressure * std::pow(ratio, -gamma)), 1.0, rounding);
    const double energy = airPressure / (gamma - 1.0) * (std::pow(ratio, 1.0 - gamma) - 1.0);
    EXPECT_NEAR(gas.energy(), energy, rounding * airPressure / (gamma - 1.0));
    EXPECT_NEAR(gas.speed(), std::sqrt(gamma * airPressure * std::pow(ratio, 1.0 - gamma) / airDensity),
                1e-10 * 374.0);
    for (int i = shearBegin<D>; i < shearEnd<D>; ++i)
      EXPECT_EQ(gas.tau[i], 0.0);
    EXPECT_EQ(gas.dissipated(), 0.0);
  }
}

/// Stored energy less the work -p dJ by Gauss's rule of three points in each of many steps: an error of the
/// sixth derivative of p times the seventh power of a step of 1e-3 of J, below 1e-15 of the energy.
template <int D>
double openEnergy(const Teuchos::ParameterList& list, double ratio)
{
  Particle<D> at(list);
  constexpr int steps = 1000;
  constexpr double node = 0.7745966692414834, weight[3] = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
  const auto cube = [](double J)
  {
    Gradient<D> F = identity<D>();
    for (int d = 0; d < D; ++d)
      F[d * D + d] = std::pow(J, 1.0 / D);
    return F;
  };
  double work = 0.0;
  for (int k = 0; k < steps; ++k)
  {
    const double from = 1.0 + (ratio - 1.0) * k / steps, change = (ratio - 1.0) / steps;
    for (int q = 0; q < 3; ++q)
    {
      at.to(cube(from + 0.5 * change * (1.0 + node * (q - 1))), 1e-6);
      work -= weight[q] * at.pressure() * change;
    }
  }
  at.to(cube(ratio), 1e-6);
  return at.energy() - work;
}

} // namespace

TEST(Fluid, GasKeepsItsAdiabate)
{
  checkAdiabate<2>();
  checkAdiabate<3>();
}

TEST(Fluid, StoresItsWork)
{
  DrawFluid draw;
  for (int sample = 0; sample < 10; ++sample)
  {
    const double ratio = draw.between(0.3, 3.0), slight = draw.between(0.8, 1.2);
    EXPECT_NEAR(openEnergy<2>(air(), ratio), 0.0, 1e-11 * airPressure);
    EXPECT_NEAR(openEnergy<3>(air(), ratio), 0.0, 1e-11 * airPressure);
    EXPECT_NEAR(openEnergy<2>(water(), slight), 0.0, 1e-12 * waterBulk);
    EXPECT_NEAR(openEnergy<3>(water(), slight), 0.0, 1e-12 * waterBulk);
  }
}

/// The energy of a small strain keeps its digits: K/2 (J - 1)^2 up to its cube.
TEST(Fluid, TaitHasItsPressure)
{
  DrawFluid draw;
  Random random;
  Particle<3> liquid(water());
  for (int sample = 0; sample < 50; ++sample)
  {
    const double J = draw.between(0.7, 1.1);
    liquid.to(shapeOf<3>(J, random), draw.between(1e-7, 1e-3));
    const double expected = waterBulk / waterExponent * (std::pow(J, -waterExponent) - 1.0);
    EXPECT_NEAR(liquid.pressure(), expected, 1e-14 * 20.0 * waterBulk);
    EXPECT_NEAR(liquid.speed(), std::sqrt(waterBulk * std::pow(J, 1.0 - waterExponent) / waterDensity),
                1e-10 * 1483.0);
  }
  const double strain = 1e-7;
  Gradient<3> F = identity<3>();
  F[0] -= strain;
  liquid.to(F, 1e-6);
  EXPECT_NEAR(liquid.energy() / (0.5 * waterBulk * strain * strain), 1.0, 1e-6);
}

/// Below the cut-off a liquid has voids: constant pressure, and no energy is lost when they close.
TEST(Fluid, LiquidOpensVoids)
{
  Teuchos::ParameterList list = water();
  list.set("Initial Pressure", 1e5);
  list.set("Cut-Off Pressure", 2e3);
  Particle<2> liquid(list);
  Gradient<2> F = identity<2>();
  F[0] = 1.3;
  liquid.to(F, 1e-6);
  EXPECT_NEAR(liquid.pressure(), 2e3, 1e-9);
  const double voids = std::pow(1.0 + waterExponent * (2e3 - 1e5) / waterBulk, -1.0 / waterExponent);
  const double stored = liquid.energy();
  F[0] = 1.2;
  liquid.to(F, 1e-6);
  EXPECT_NEAR(liquid.energy() - stored, 2e3 * 0.1, 1e-9 * waterBulk * 1e-6);
  EXPECT_GE(liquid.speed(), 0.99 * std::sqrt(waterBulk / waterDensity));
  F[0] = voids * (1.0 + 1e-12);
  liquid.to(F, 1e-6);
  const double above = liquid.energy();
  F[0] = voids * (1.0 - 1e-12);
  liquid.to(F, 1e-6);
  EXPECT_NEAR(liquid.energy(), above, 1e-6);
  EXPECT_NEAR(liquid.pressure(), 2e3, 1.0);
}

/// Without a cut-off the pressure of Tait has the limit -K/n; a gas never has a negative one.
TEST(Fluid, Tension)
{
  Particle<2> liquid(water()), gas(air());
  Gradient<2> F = identity<2>();
  F[0] = 50.0;
  liquid.to(F, 1e-6);
  gas.to(F, 1e-6);
  EXPECT_NEAR(liquid.pressure(), -waterBulk / waterExponent, 1e-6 * waterBulk);
  EXPECT_GT(gas.pressure(), 0.0);
}

/// Work of all viscosities over a compression in many steps: with the trapezoidal rule for the work, stored
/// energy, dissipation and work close but for the square of a step; and the gas is as warm as its energy.
TEST(Fluid, ViscosityWarmsAGas)
{
  Teuchos::ParameterList list = air();
  list.set("Linear Viscosity", 0.2);
  list.set("Quadratic Viscosity", 2.0);
  list.set("Viscosity", 3.0);
  Particle<3> gas(list);
  double work = 0.0;
  constexpr int steps = 2000;
  for (int k = 1; k <= steps; ++k)
  {
    Gradient<3> F = gas.F;
    F[0] = 1.0 - 0.5 * k / steps;
    const double before = gas.tau[0], stretch = gas.F[0];
    gas.to(F, 1e-3 / steps);
    work += 0.5 * (before + gas.tau[0]) * 2.0 * (F[0] - stretch) / (F[0] + stretch);
  }
  EXPECT_GT(gas.dissipated(), 0.02 * work);
  EXPECT_NEAR(gas.energy() + gas.dissipated(), work, 1e-4 * work);
  // At once at rest: only what the last step had of viscous stress is left above the equation of state.
  const double energy = gas.history[Fluid::energyIndex<3>], heat = gas.history[Fluid::heatIndex<3>];
  EXPECT_NEAR(heat, gas.dissipated(), 0.01 * heat);
  const double viscous = gas.history[Fluid::viscousIndex<3>] / gas.volume();
  const double hot = (gamma - 1.0) * (airPressure / (gamma - 1.0) + energy) / gas.volume();
  EXPECT_NEAR(gas.pressure() - viscous, hot, 1e-10 * hot);
  EXPECT_GT(hot, airPressure * std::pow(2.0, gamma));
}

/// Shear at a constant rate: eta times the rate, and its square times the time; no stress in a rotation.
template <int D>
void checkShear()
{
  constexpr double eta = 7.0, rate = 40.0, dt = 1e-5;
  Teuchos::ParameterList list = water();
  list.set("Viscosity", eta);
  Particle<D> liquid(list);
  constexpr int steps = 300, xy = symmetricIndex<D>(0, 1);
  for (int k = 1; k <= steps; ++k)
  {
    Gradient<D> F = identity<D>();
    F[1] = rate * dt * k;
    liquid.to(F, dt);
    EXPECT_NEAR(liquid.tau[xy], eta * rate, 1e-10 * eta * rate);
    EXPECT_NEAR(liquid.tau[0], 0.0, 1e-6);
  }
  // The first step's stress starts at zero, of which the trapezoidal rule has the half.
  EXPECT_NEAR(liquid.dissipated(), eta * rate * rate * dt * (steps - 0.5),
              1e-9 * eta * rate * rate * dt * steps);
  const double V = 2.0 * D * eta / (waterDensity * 0.01), c = std::sqrt(waterBulk / waterDensity);
  EXPECT_NEAR(liquid.speed(), V + std::sqrt(V * V + c * c), 1e-9 * c);
  Random random;
  for (int k = 0; k < 20; ++k)
  {
    liquid.to(multiply<D>(random.rotation<D>(), liquid.F), dt);
    for (int i = 0; i < symmetricSize<D>; ++i)
      EXPECT_NEAR(liquid.tau[i], 0.0, 1e-14 * (eta / dt + waterBulk) * 1e2) << i;
  }
}

TEST(Fluid, NewtonsViscosity)
{
  checkShear<2>();
  checkShear<3>();
}

TEST(Fluid, RefusesWhatIsNoFluid)
{
  EXPECT_EQ(refusalOf("Sea", water()), "");
  EXPECT_EQ(refusalOf("Sea", air(), Plane::Strain), "");
  Teuchos::ParameterList list = air();
  list.set("Heat Capacity Ratio", 1.0);
  expectIn(refusalOf("Sea", list), "Materials > Sea > Heat Capacity Ratio: is 1; give a number above 1");
  list.set("Bulk Modulus", 1e9);
  expectIn(refusalOf("Sea", list), "Bulk Modulus: is not of Equation Of State = Ideal Gas");
  list = air();
  list.remove("Initial Pressure");
  expectIn(refusalOf("Sea", list),
           "Initial Pressure: a Fluid material needs it; give the pressure of the gas");
  list.set("Specific Gas Constant", 287.0);
  EXPECT_NEAR(fluid<3>(list).own[FluidNumber::initialPressure], 287.0 * 293.15 * airDensity, 1e-9);
  list.set("Initial Pressure", 1e5);
  expectIn(refusalOf("Sea", list), "Initial Pressure: and Specific Gas Constant are both given");
  list = water();
  list.set("Cut-Off Pressure", 1e3);
  expectIn(refusalOf("Sea", list),
           "Cut-Off Pressure: is 1000 Pa, above Initial Pressure = 0 Pa: the liquid would have voids");
  list = water();
  list.set("Tait Exponent", 1.0);
  expectIn(refusalOf("Sea", list), "Tait Exponent: is 1; give a number above 1");
  list.set("Equation Of State", "Steam");
  expectIn(refusalOf("Sea", list), "Equation Of State: is \"Steam\"; write Ideal Gas or Tait.");
}

} // namespace Test
} // namespace Rhegma
