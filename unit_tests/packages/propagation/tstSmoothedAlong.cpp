/// Values of front nodes, smoothed along the front.

#include "propagation/SmoothedAlong.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace Rhegma;
using propagation::smoothedAlong;

namespace
{

/// A front of nodes that all advance.
CrackFront<3> frontOf(int count, bool closed)
{
  CrackFront<3> front;
  front.nodes.resize(count);
  for (int k = 0; k < count; ++k)
  {
    front.nodes[k].facet = closed || k + 1 < count ? k : -1;
    front.nodes[k].advances = true;
  }
  return front;
}

} // namespace

/// A hat (1, 2, 1) / 4 twice is (1, 4, 6, 4, 1) / 16, also across the seam of a closed front.
TEST(SmoothedAlong, SpreadsAValueOverFiveNodes)
{
  std::vector<double> value(9, 0.0);
  value[1] = 16.0;
  const std::vector<double> found = smoothedAlong(frontOf(9, true), value);
  const std::vector<double> expected = {4.0, 6.0, 4.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0};
  for (std::size_t k = 0; k < found.size(); ++k)
    EXPECT_NEAR(found[k], expected[k], 1e-14) << k;
}

/// A wave along a closed front keeps cos^4 (pi / nodes of a wave) of its height; its mean stays.
TEST(SmoothedAlong, DampsShortWaves)
{
  for (const int wave : {4, 8, 16})
  {
    const int count = 3 * wave;
    std::vector<double> value(count);
    for (int k = 0; k < count; ++k)
      value[k] = 1.0 + std::cos(2.0 * M_PI * k / wave);
    const std::vector<double> found = smoothedAlong(frontOf(count, true), value);
    const double kept = std::pow(std::cos(M_PI / wave), 4);
    for (int k = 0; k < count; ++k)
      EXPECT_NEAR(found[k], 1.0 + kept * (value[k] - 1.0), 1e-13) << wave << " " << k;
  }
}

/// Neither the ends of an open front nor nodes that stay change a uniform value.
TEST(SmoothedAlong, KeepsUniformValues)
{
  CrackFront<3> front = frontOf(7, false);
  front.nodes[3].advances = false;
  std::vector<double> value(7, 2.0);
  value[3] = 0.0;
  const std::vector<double> found = smoothedAlong(front, value);
  for (const int k : {0, 1, 2, 4, 5, 6})
    EXPECT_NEAR(found[k], 2.0, 1e-14) << k;
  EXPECT_EQ(smoothedAlong(frontOf(1, false), {3.0}), std::vector<double>{3.0});
}
