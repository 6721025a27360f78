/// Principal and von Mises stress of any tensor.

#include "material/PrincipalStress.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace Rhegma;

namespace
{

/// Six components of R diag(values) R^T, R a rotation by a random unit quaternion.
template <class Random>
void turned(const double* values, Random& random, double* s)
{
  std::normal_distribution<double> normal;
  double q[4], length = 0.0;
  for (double& component : q)
  {
    component = normal(random);
    length += component * component;
  }
  for (double& component : q)
    component /= std::sqrt(length);
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  const double R[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
                          {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
                          {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
  const int at[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}};
  for (int c = 0; c < 6; ++c)
  {
    s[c] = 0.0;
    for (int k = 0; k < 3; ++k)
      s[c] += R[at[c][0]][k] * values[k] * R[at[c][1]][k];
  }
}

} // namespace

/// The rotation has a round-off of a few parts in 1e16; equal values, on which closed formulas lose half of
/// the digits, are drawn as well.
TEST(PrincipalStress, OfTurnedTensors)
{
  const unsigned seed = std::random_device()();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> between(-1.0, 1.0);
  for (int trial = 0; trial < 2000; ++trial)
  {
    double values[3] = {between(random), between(random), between(random)};
    if (trial % 3 == 0)
      values[1] = values[0] * (1.0 + (trial % 2 == 0 ? 0.0 : 1e-12));
    double s[6];
    turned(values, random, s);
    const double scale = std::max({std::fabs(values[0]), std::fabs(values[1]), std::fabs(values[2])});
    ASSERT_NEAR(largestPrincipalStress(s), std::max({values[0], values[1], values[2]}), 1e-14 * scale);
    const double a = values[0] - values[1], b = values[1] - values[2], c = values[2] - values[0];
    ASSERT_NEAR(vonMisesStress(s), std::sqrt(0.5 * (a * a + b * b + c * c)), 1e-7 * scale);
  }
}

TEST(PrincipalStress, OfSimpleStates)
{
  const double bar[6] = {7, 0, 0, 0, 0, 0}, shear[6] = {0, 0, 0, 3, 0, 0},
               pressure[6] = {-2, -2, -2, 0, 0, 0};
  const double across[6] = {1, 2, 9, 0.5, 0, 0}, none[6] = {};
  EXPECT_EQ(largestPrincipalStress(bar), 7.0);
  EXPECT_DOUBLE_EQ(largestPrincipalStress(shear), 3.0);
  EXPECT_EQ(largestPrincipalStress(pressure), -2.0);
  EXPECT_EQ(largestPrincipalStress(across), 9.0);
  EXPECT_EQ(largestPrincipalStress(none), 0.0);
}
