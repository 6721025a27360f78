/// What an oscillation that decays still has before it, compared with what it does.

#include "base/Decay.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace
{

std::vector<double> series(const std::function<double(double)>& of, int count)
{
  std::vector<double> values;
  for (int k = 0; k < count; ++k)
    values.push_back(of(k));
  return values;
}

/// How far a series goes from its value at `count` later on.
double goes(const std::function<double(double)>& of, int count)
{
  double most = 0.0;
  for (int k = count; k < 100 * count; ++k)
    most = std::max(most, std::fabs(of(k) - of(count - 1)));
  return most;
}

} // namespace

/// Wherever in its period a damped oscillation is left, it still goes no further than is said, and half as
/// far at least.
TEST(Decay, OfAnOscillation)
{
  const auto of = [](double k) { return 5.0 + std::exp(-0.02 * k) * std::cos(0.25 * k); };
  for (int count = 100; count < 140; count += 3)
  {
    const double said = Rhegma::remainingChange(series(of, count));
    EXPECT_GT(said, 0.95 * goes(of, count)) << count;
    EXPECT_LT(said, 3.5 * goes(of, count)) << count;
  }
}

/// A start from rest, as of a body that is loaded suddenly, does not count.
TEST(Decay, OfAnOscillationAfterAStart)
{
  const auto of = [](double k)
  { return k < 40 ? 1e-9 * std::cos(k) : 5.0 - 5.0 * std::exp(0.04 * (40 - k)) * std::cos(0.3 * (k - 40)); };
  const double said = Rhegma::remainingChange(series(of, 240));
  EXPECT_GT(said, 0.95 * goes(of, 240));
  EXPECT_LT(said, 3.5 * goes(of, 240));
}

/// 5 - exp(-0.05 k) has exp(-0.05 k) left.
TEST(Decay, OfAnApproach)
{
  const auto of = [](double k) { return 5.0 - std::exp(-0.05 * k); };
  EXPECT_NEAR(Rhegma::remainingChange(series(of, 40)), std::exp(-0.05 * 39), 1e-9);
}

TEST(Decay, OfTooFewValuesIsUnknown)
{
  EXPECT_TRUE(std::isnan(Rhegma::remainingChange({1.0, 2.0, 1.5})));
  EXPECT_TRUE(std::isinf(Rhegma::intervalsUntil({1.0, 0.5, 0.25}, 0.01)));
}

/// exp(-0.1 k) is below 1e-4 from k = 92.1 on; of 40 values the last is k = 39, and the envelope of the last
/// quarter that of its first value, k = 30.
TEST(Decay, UntilALimit)
{
  const auto of = [](double k) { return std::exp(-0.1 * k); };
  EXPECT_NEAR(Rhegma::intervalsUntil(series(of, 40), 1e-4), 92.1 - 30.0, 0.1);
  EXPECT_EQ(Rhegma::intervalsUntil(series(of, 40), 0.5), 0.0);
  EXPECT_TRUE(std::isinf(Rhegma::intervalsUntil(std::vector<double>(40, 1.0), 1e-4)));
}

/// The range over which 5 + exp(-0.1 k) moves in a quarter of the values falls by exp(-1) from quarter to
/// quarter; it is exp(-3) - exp(-3.9) in the last one.
TEST(Decay, UntilStill)
{
  const auto of = [](double k) { return 5.0 + std::exp(-0.1 * k); };
  const double range = std::exp(-3.0) - std::exp(-3.9);
  EXPECT_NEAR(Rhegma::intervalsUntilStill(series(of, 40), 1e-4), 10.0 * std::log(range / (1e-4 * of(39))),
              0.01);
}
