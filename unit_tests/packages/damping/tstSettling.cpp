/// When a damped run has settled.

#include "damping/Settling.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Rhegma::damping
{
namespace Test
{

namespace
{

/// Samples until it is at rest, ten at most. \param rate of each sample, by its number
template <class Rate>
int samplesToRest(Settling settling, const Rate& rate)
{
  for (int k = 1; k < 10; ++k)
    if (settling.sample(1e-6, 1.0, {{"Notch.0.G_J", rate(k)}}))
      return k;
  return 10;
}

} // namespace

/// Three samples have to agree to 1 %: 1, 1/2, ... 1/2^k come closer and never do, 1 + 1/4^k do once 1/4^k is
/// 1 % of all three, that is in the samples 4, 5 and 6 (1/256 at most).
TEST(Settling, WaitsForRatesThatStay)
{
  const Settling settling(1e-4, 1e-2, 3);
  EXPECT_EQ(samplesToRest(settling, [](int) { return 2.0; }), 3);
  EXPECT_EQ(samplesToRest(settling, [](int k) { return std::ldexp(1.0, -k); }), 10);
  EXPECT_EQ(samplesToRest(settling, [](int k) { return 1.0 + std::ldexp(1.0, -2 * k); }), 6);
}

TEST(Settling, WaitsForTheMotionToEnd)
{
  Settling settling(1e-4, 1e-2, 2);
  EXPECT_FALSE(settling.sample(1e-3, 1.0, {}));
  EXPECT_FALSE(settling.sample(1e-5, 1.0, {}));
  EXPECT_TRUE(settling.sample(1e-5, 1.0, {}));
}

/// On a plateau before the last change of loads all is at rest, and again just after it, before the bodies
/// have answered.
TEST(Settling, WaitsForLoads)
{
  Settling settling(1e-4, 1e-2, 3);
  settling.waitForLoads(10.0, 5.0);
  for (int k = 0; k < 15; ++k)
    EXPECT_FALSE(settling.sample(1e-6, 1.0, {{"Notch.0.G_J", 2.0}}, k)) << k;
  EXPECT_TRUE(settling.sample(1e-6, 1.0, {{"Notch.0.G_J", 2.0}}, 15.0));
  Settling late(1e-4, 1e-2, 3);
  late.waitForLoads(10.0, 0.0);
  for (int k = 0; k < 12; ++k)
    EXPECT_FALSE(late.sample(1e-6, 1.0, {{"Notch.0.G_J", 2.0}}, k)) << k;
  EXPECT_TRUE(late.sample(1e-6, 1.0, {{"Notch.0.G_J", 2.0}}, 12.0));
}

/// Without crack closure the other rates decide. A rate that is lost during the run is no rest.
TEST(Settling, LooksAtNumbersAlone)
{
  const double none = std::numeric_limits<double>::quiet_NaN();
  Settling settling(1e-4, 1e-2, 2);
  EXPECT_FALSE(settling.sample(1e-6, 1.0, {{"Notch.0.G_J", 5.0}, {"Notch.0.G_closure", 4.0}}));
  EXPECT_FALSE(settling.sample(1e-6, 1.0, {{"Notch.0.G_J", 5.0}, {"Notch.0.G_closure", none}}));
  EXPECT_TRUE(settling.sample(1e-6, 1.0, {{"Notch.0.G_J", 5.0}, {"Notch.0.G_closure", none}}));
  EXPECT_FALSE(settling.sample(1e-6, 1.0, {{"Notch.0.G_J", 6.0}, {"Notch.0.G_closure", none}}));
}

/// One mode of the mass 1 and the stiffness w^2 = 1, r times damped, creeps to rest from the displacement 2
/// to 1: x = 1 + exp(-t / s), with v = -(x - 1) / s, while G stands still at a turning point. What its
/// energies still change by, 2 exp(-t / s) to first order, must be less than a hundred times the drift.
TEST(Settling, WaitsForABodyThatCreeps)
{
  constexpr double r = 100.0, drift = 1e-4;
  const double s = 0.5 * r + std::sqrt(0.25 * r * r - 1.0); // of v' = -r v - x
  Settling strong(1e-3, drift, 5, r), unknown(1e-3, drift, 5);
  double rest = -1.0;
  bool atOnce = false;
  for (int k = 0; k < 1200 && rest < 0.0; ++k)
  {
    const double t = 20.0 + k, left = std::exp(-t / s);
    const double kinetic = 0.5 * left * left / (s * s), strain = 0.5 * (1.0 + left) * (1.0 + left);
    if (strong.sample(kinetic, strain, {{"Notch.0.G_J", 5.0}}, t))
      rest = left;
    atOnce = atOnce || (k < 40 && unknown.sample(kinetic, strain, {{"Notch.0.G_J", 5.0}}, t));
  }
  EXPECT_TRUE(atOnce);
  EXPECT_LT(2.0 * rest, 100.0 * drift);
  EXPECT_GT(2.0 * rest, 80.0 * drift);
  EXPECT_NEAR(strong.mayStillChange(), 2.0 * rest, 0.02 * rest);
}

/// Modes of the frequency w = 1, damped ten times and a half of critical. Both rates of decay of the first
/// have the product 1, so that its frequency follows from the slower one; the second oscillates.
TEST(Settling, MeasuresTheFrequencyOfAMotionThatCreeps)
{
  for (const double r : {20.0, 1.0})
  {
    const double s = 0.5 * r + std::sqrt(std::max(0.0, 0.25 * r * r - 1.0));
    Settling settling(1e-12, 1e-12, 5, r);
    EXPECT_FALSE(settling.frequencyOfCreep());
    for (int k = 1; k < 100; ++k)
    {
      const double t = 0.5 * k,
                   v = r > 2.0 ? std::exp(-t / s) : std::exp(-0.5 * r * t) * std::sin(std::sqrt(0.75) * t);
      settling.sample(0.5 * v * v, 1.0, {}, t);
    }
    ASSERT_EQ(settling.frequencyOfCreep().has_value(), r > 2.0);
    EXPECT_NEAR(settling.frequencyOfCreep().value_or(1.0), 1.0, 1e-6);
  }
}

/// Two samples at a turning point agree, and G is far from rest all the same: what it may still change is
/// told. 100 + exp(-0.02 k) cos(0.25 k) goes down by up to 2 exp(-0.02 k) from its upper turning point at k
/// = 75.
TEST(Settling, TellsHowFarRatesMayStillGo)
{
  Settling settling(1e-4, 1e-2, 2);
  EXPECT_TRUE(std::isnan(settling.mayStillChange()));
  for (int k = 0; k <= 126; ++k)
  {
    const double rate = 100.0 + std::exp(-0.02 * k) * std::cos(0.25 * k);
    settling.sample(1e-6, 1.0, {{"Notch.0.G_J", rate}, {"Notch.1.G_J", 50.0}});
  }
  const double left = std::exp(-0.02 * 126) * (1.0 + std::exp(-0.02 * 12.57)) / 100.0;
  EXPECT_GT(settling.mayStillChange(), 0.95 * left);
  EXPECT_LT(settling.mayStillChange(), 3.5 * left);
}

} // namespace Test
} // namespace Rhegma::damping
