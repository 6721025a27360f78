/// When a damped run has settled.

#include "damping/Settling.hpp"

#include <gtest/gtest.h>

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
