/// Means of functions that change in a small part of an interval.

#include "base/AdaptiveMean.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <random>

using Rhegma::adaptiveMean;

namespace
{

const double pi = std::acos(-1.0);

} // namespace

TEST(AdaptiveMean, OfPolynomials)
{
  EXPECT_DOUBLE_EQ(adaptiveMean([](double) { return 3.0; }, -1.0, 4.0), 3.0);
  EXPECT_NEAR(adaptiveMean([](double t) { return t * t * t - 2.0 * t; }, 0.0, 2.0), 0.0, 1e-14);
}

/// A smooth pulse somewhere in the interval, a fiftieth of it long or more.
TEST(AdaptiveMean, OfPulses)
{
  const unsigned seed = 31;
  std::cout << "seed " << seed << "\n";
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int k = 0; k < 40; ++k)
  {
    const double width = 0.02 + 0.3 * uniform(random), start = (1.0 - width) * uniform(random);
    const auto pulse = [&](double t)
    { return t > start && t < start + width ? 1.0 - std::cos(2.0 * pi * (t - start) / width) : 0.0; };
    EXPECT_NEAR(adaptiveMean(pulse, 0.0, 1.0), width, 1e-8);
  }
}

/// A jump anywhere: to a piece that is halved 20 times.
TEST(AdaptiveMean, OfJumps)
{
  const unsigned seed = 32;
  std::cout << "seed " << seed << "\n";
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int k = 0; k < 40; ++k)
  {
    const double at = uniform(random);
    EXPECT_NEAR(adaptiveMean([&](double t) { return t < at ? 1.0 : 0.0; }, 0.0, 1.0), at, 1e-8);
  }
}

/// Rounding before a pulse does not use up the values that the pulse needs, and a wave of 1024 periods, whose
/// zeros lie at all multiples of a power of two, is seen.
TEST(AdaptiveMean, OfPulsesAfterRoundingAndOfWaves)
{
  const auto afterRounding = [](double t)
  {
    const double rounding =
        std::cos(1e3 * t) * std::cos(1e3 * t) + std::sin(1e3 * t) * std::sin(1e3 * t) - 1.0;
    return rounding + (t > 0.7 && t < 0.712 ? 1.0 : 0.0);
  };
  EXPECT_NEAR(adaptiveMean(afterRounding, 0.0, 1.0), 0.012, 1e-8);
  // Two of the 2053 pieces may look smooth by chance.
  const auto wave = [](double t) { return 1.0 - std::cos(2.0 * pi * 1024.0 * t); };
  EXPECT_NEAR(adaptiveMean(wave, 0.0, 1.0), 1.0, 1e-3);
}

/// A pulse of a two thousandth of the interval is seen wherever it lies.
TEST(AdaptiveMean, OfShortPulses)
{
  for (int k = 0; k < 97; ++k)
  {
    const double start = k / 97.0;
    const double mean =
        adaptiveMean([&](double t) { return t > start && t < start + 5e-4 ? 1000.0 : 0.0; }, 0.0, 1.0);
    EXPECT_NEAR(mean, 0.5, 1e-4) << start;
  }
}

/// A function that is rough everywhere ends, too.
TEST(AdaptiveMean, OfRoughFunctionsEnds)
{
  int count = 0;
  const auto rough = [&](double t)
  {
    ++count;
    return std::sin(1e12 * t);
  };
  EXPECT_LT(std::fabs(adaptiveMean(rough, 0.0, 1.0)), 0.1);
  EXPECT_LT(count, 2053 * 250);
}
