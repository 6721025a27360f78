#include "grid/ShapeFunctions.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>

using namespace Rhegma;

namespace
{

/// A few roundings of numbers up to the coordinate.
constexpr double roundOff = 1e-14;

template <int N>
void expectComplete(const AxisStencil<N>& s, double at)
{
  double one = 0.0, position = 0.0, zero = 0.0, slope = 0.0;
  for (int k = 0; k < N; ++k)
  {
    EXPECT_GE(s.weight[k], 0.0);
    one += s.weight[k];
    position += s.weight[k] * (s.first + k);
    zero += s.slope[k];
    slope += s.slope[k] * (s.first + k);
  }
  EXPECT_NEAR(one, 1.0, roundOff);
  EXPECT_NEAR(position, at, roundOff * at);
  EXPECT_NEAR(zero, 0.0, roundOff);
  EXPECT_NEAR(slope, 1.0, roundOff * at);
}

template <int N>
std::map<int, double> weights(const AxisStencil<N>& s)
{
  std::map<int, double> found;
  for (int k = 0; k < N; ++k)
    found[s.first + k] = s.weight[k];
  return found;
}

/// Textbook uniform GIMP of a node at distance x, both in cells.
double textbook(double x, double half)
{
  x = std::fabs(x);
  if (x < half)
    return 1.0 - (x * x + half * half) / (2.0 * half);
  if (x < 1.0 - half)
    return 1.0 - x;
  if (x < 1.0 + half)
    return (1.0 + half - x) * (1.0 + half - x) / (4.0 * half);
  return 0.0;
}

} // namespace

TEST(ShapeFunctions, LinearByHand)
{
  const AxisStencil<2> s = linearStencil(3.25);
  EXPECT_EQ(s.first, 3);
  EXPECT_EQ(s.weight[0], 0.75);
  EXPECT_EQ(s.weight[1], 0.25);
  EXPECT_EQ(s.slope[0], -1.0);
  EXPECT_EQ(s.slope[1], 1.0);
}

/// A box of half a cell about node 3: an eighth of it is lost to the slopes on each side.
TEST(ShapeFunctions, GimpByHand)
{
  const AxisStencil<3> s = gimpStencil(3.0, 0.25);
  EXPECT_EQ(s.first, 2);
  EXPECT_EQ(s.weight[0], 0.0625);
  EXPECT_EQ(s.weight[1], 0.875);
  EXPECT_EQ(s.weight[2], 0.0625);
  EXPECT_EQ(s.slope[0], -0.5);
  EXPECT_EQ(s.slope[1], 0.0);
  EXPECT_EQ(s.slope[2], 0.5);
}

TEST(ShapeFunctions, AreLinearlyCompleteEverywhere)
{
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> position(4.0, 20.0), width(1e-3, 0.5);
  for (int trial = 0; trial < 1000; ++trial)
  {
    const double at = position(engine);
    expectComplete(linearStencil(at), at);
    expectComplete(gimpStencil(at, width(engine)), at);
  }
}

TEST(ShapeFunctions, GimpIsThatOfTheTextbook)
{
  std::mt19937 engine(8);
  std::uniform_real_distribution<double> position(4.0, 20.0), width(1e-3, 0.5);
  for (int trial = 0; trial < 1000; ++trial)
  {
    const double at = position(engine), half = width(engine);
    for (const auto& entry : weights(gimpStencil(at, half)))
      // The textbook's form loses digits where it divides by a small box.
      EXPECT_NEAR(entry.second, textbook(at - entry.first, half), roundOff / half);
  }
}

/// GIMP's weights are quadratic from kink to kink, so that central differences are exact away from kinks.
TEST(ShapeFunctions, SlopesAreThoseOfTheWeights)
{
  std::mt19937 engine(9);
  std::uniform_real_distribution<double> position(4.0, 20.0), width(0.05, 0.45);
  constexpr double h = 1e-3;
  int tried = 0;
  for (int trial = 0; trial < 1000; ++trial)
  {
    const double at = position(engine), half = width(engine);
    const auto kink = [&](double edge) { return std::fabs(edge - std::round(edge)) < 2.0 * h; };
    if (kink(at - half) || kink(at + half))
      continue;
    ++tried;
    const AxisStencil<3> s = gimpStencil(at, half);
    const auto before = weights(gimpStencil(at - h, half)), after = weights(gimpStencil(at + h, half));
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(s.slope[k], (after.at(s.first + k) - before.at(s.first + k)) / (2.0 * h), 1e-12 / h);
  }
  EXPECT_GT(tried, 900);
}

TEST(ShapeFunctions, GimpOfATinyBoxIsLinear)
{
  const AxisStencil<3> box = gimpStencil(5.3, 1e-9);
  const AxisStencil<2> point = linearStencil(5.3);
  EXPECT_EQ(box.first, point.first);
  for (int k = 0; k < 2; ++k)
    EXPECT_NEAR(box.weight[k], point.weight[k], 1e-6); // the box's lower edge is known to 1e-15 of 1e-9
}
