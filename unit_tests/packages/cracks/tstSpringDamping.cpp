/// The damping of front springs: a spring of two masses with added inertia, stepped as nodes are.

#include "cracks/HoldingForce.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

namespace Rhegma::cracks
{

namespace
{

/// Relative motion of the masses of a node on their spring.
struct Oscillator
{
  double stiffness, inertia, damping, dt;
  double stretch = 1.0, rate = 0.0;

  /// \param ratio stiffness over reduced mass / dt^2
  Oscillator(double ratio, double reducedMass, double step)
      : stiffness(ratio * reducedMass / (step * step)),
        inertia(reducedMass + springs::addedInertia * stiffness * step * step),
        damping(stableDamping(stiffness, inertia, step)),
        dt(step)
  {
  }

  void step()
  {
    rate -= dt / inertia * (stiffness * stretch + damping * rate);
    stretch += dt * rate;
  }

  double energy() const { return 0.5 * (inertia * rate * rate + stiffness * stretch * stretch); }
};

} // namespace

TEST(SpringDamping, EndsAnyOscillationOfAnySpring)
{
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> exponent(-6.0, 6.0), scale(-3.0, 3.0);
  for (int k = 0; k < 200; ++k)
  {
    Oscillator one(std::pow(10.0, exponent(random)), std::pow(10.0, scale(random)),
                   std::pow(10.0, scale(random)));
    const double start = one.energy();
    // Ten periods: exp(-2 zeta 2 pi 10) = 1e-38 of the energy would be left with the full damping. The
    // stiffest spring, s = k dt^2 / inertia = 2, has 44 steps, each with a third of the energy before.
    const int steps = static_cast<int>(10.0 * 6.283 * std::sqrt(one.inertia / one.stiffness) / one.dt) + 1;
    double most = start;
    for (int i = 0; i < steps; ++i)
    {
      one.step();
      most = std::max(most, one.energy());
    }
    EXPECT_LT(one.energy(), 1e-12 * start);
    // The first step takes the stretch from 1 to 1 - s.
    const double s = one.stiffness * one.dt * one.dt / one.inertia;
    EXPECT_LE(most, std::max(1.0, s + (1.0 - s) * (1.0 - s)) * (1.0 + 1e-12) * start);
  }
}

/// The condition of stability in the documentation of stableDamping, with a material of any stiffness.
TEST(SpringDamping, LeavesTheMaterialItsStiffness)
{
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> exponent(-3.0, 3.0);
  for (int k = 0; k < 200; ++k)
  {
    const double mass = 2.0, dt = 0.5, unit = mass / (dt * dt);
    for (const double part : {0.99, 1.01})
    {
      Oscillator one(std::pow(10.0, exponent(random)), mass, dt);
      const double most = 4.0 * one.inertia / (dt * dt) - 2.0 * one.damping / dt;
      EXPECT_GT(most - one.stiffness, 3.31 * unit);
      one.stiffness = part * most;
      const double start = one.energy();
      // One root is about -1 - 0.01, or closer to -1 by what damping takes of the other: 2,000 steps tell.
      for (int i = 0; i < 2000; ++i)
        one.step();
      if (part < 1.0)
        EXPECT_LT(one.energy(), 0.1 * start);
      else
        EXPECT_GT(one.energy(), 10.0 * start);
    }
  }
}

TEST(SpringDamping, IsThatOfTheConstantWhereStepsAreShort)
{
  Oscillator one(1e-8, 3.0, 0.2); // omega dt = 1e-4
  const double omega = std::sqrt(one.stiffness / one.inertia), zeta = springs::damping;
  EXPECT_NEAR(one.damping, 2.0 * zeta * one.inertia * omega, 2e-4 * one.damping);
  const int steps = 20000;
  for (int i = 0; i < steps; ++i)
    one.step();
  // x = exp(-zeta w t) (cos(wd t) + zeta w / wd sin(wd t))
  const double t = steps * one.dt, damped = omega * std::sqrt(1.0 - zeta * zeta);
  const double right =
      std::exp(-zeta * omega * t) * (std::cos(damped * t) + zeta * omega / damped * std::sin(damped * t));
  EXPECT_NEAR(one.stretch, right, 2e-4);
}

TEST(SpringDamping, IsNoneWithoutASpringOrInertia)
{
  EXPECT_EQ(stableDamping(0.0, 1.0, 1.0), 0.0);
  EXPECT_EQ(stableDamping(5.0, 0.0, 1.0), 0.0);
}

} // namespace Rhegma::cracks
