/// The damping of front springs: a spring of two masses, stepped as nodes are.

#include "cracks/HoldingForce.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace Rhegma::cracks
{

namespace
{

/// Relative motion of the masses of a node on their spring.
struct Oscillator
{
  double stiffness, mass, damping, dt;
  double stretch = 1.0, rate = 0.0;

  /// \param ratio stiffness over the largest stable one
  Oscillator(double ratio, double reducedMass, double step) : mass(reducedMass), dt(step)
  {
    const double most = springs::stableStiffness * mass / (dt * dt);
    stiffness = ratio * most;
    damping = stableDamping(stiffness, most, mass);
  }

  void step()
  {
    rate -= dt / mass * (stiffness * stretch + damping * rate);
    stretch += dt * rate;
  }

  double energy() const { return 0.5 * (mass * rate * rate + stiffness * stretch * stretch); }
};

} // namespace

TEST(SpringDamping, EndsAnyOscillationOfStableSprings)
{
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> exponent(-6.0, 0.0), scale(-3.0, 3.0);
  for (int k = 0; k < 200; ++k)
  {
    Oscillator one(std::pow(10.0, exponent(random)), std::pow(10.0, scale(random)),
                   std::pow(10.0, scale(random)));
    const double start = one.energy();
    // Ten periods: exp(-2 zeta 2 pi 10) = 1e-38 of the energy would be left with the full damping. Of that,
    // the largest stable spring has 1 / (1 + 2 zeta) = 0.414: 1e-16.
    const int steps = static_cast<int>(10.0 * 6.283 * std::sqrt(one.mass / one.stiffness) / one.dt) + 1;
    double most = start;
    for (int i = 0; i < steps; ++i)
    {
      one.step();
      most = std::max(most, one.energy());
    }
    EXPECT_LT(one.energy(), 1e-12 * start);
    EXPECT_LE(most, 1.5 * start) << "without damping it would vary by a factor of 2 at omega dt = 1";
  }
}

/// The condition of stability in the documentation of stableDamping, with a material of any stiffness.
TEST(SpringDamping, IsStableUpToTheStatedStiffness)
{
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> exponent(-3.0, 0.0);
  for (int k = 0; k < 200; ++k)
  {
    const double ratio = k == 0 ? 1.0 : std::pow(10.0, exponent(random));
    for (const double part : {0.99, 1.01})
    {
      Oscillator one(ratio, 2.0, 0.5);
      const double used = 2.0 * one.damping * one.dt / one.mass, unit = one.mass / (one.dt * one.dt);
      EXPECT_GT(4.0 - used - one.stiffness / unit, 1.82); // 1.828 at ratio 1
      one.stiffness = part * (4.0 - used) * unit;
      const double start = one.energy();
      for (int i = 0; i < 500; ++i)
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
  const double omega = std::sqrt(one.stiffness / one.mass), zeta = springs::damping;
  EXPECT_NEAR(one.damping, 2.0 * zeta * one.mass * omega, 2e-4 * one.damping);
  const int steps = 20000;
  for (int i = 0; i < steps; ++i)
    one.step();
  // x = exp(-zeta w t) (cos(wd t) + zeta w / wd sin(wd t))
  const double t = steps * one.dt, damped = omega * std::sqrt(1.0 - zeta * zeta);
  const double right =
      std::exp(-zeta * omega * t) * (std::cos(damped * t) + zeta * omega / damped * std::sin(damped * t));
  EXPECT_NEAR(one.stretch, right, 2e-4);
}

TEST(SpringDamping, IsNoneAtRestAndWithoutASpring)
{
  EXPECT_EQ(stableDamping(5.0, std::numeric_limits<double>::max(), 1.0), 0.0);
  EXPECT_EQ(stableDamping(0.0, 1.0, 1.0), 0.0);
  EXPECT_EQ(stableDamping(0.0, 0.0, 1.0), 0.0);
}

} // namespace Rhegma::cracks
