/// The factor of the loads with which G is the toughness.

#include "step/LoadFactorSearch.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <iostream>
#include <random>

using namespace Rhegma;

namespace
{

/// \return equilibria that were needed \param drive G/Gc of a factor \param near how near the factor must be
int search(double first, double exact, const std::function<double(double)>& drive,
           double near = 2.0 * LoadFactorSearch::tolerance)
{
  LoadFactorSearch found;
  double factor = first;
  int count = 0;
  while (!found.found() && count < 40)
  {
    found.record(factor, drive(factor));
    ++count;
    if (found.found())
      break;
    factor = found.next();
  }
  EXPECT_NEAR(factor, exact, near * exact);
  return count;
}

} // namespace

/// G is the square of the factor in a linear body: the second equilibrium is the answer, unless the first is
/// so far off that it is not trusted.
TEST(LoadFactorSearch, OfALinearBodyTakesTwo)
{
  const unsigned seed = 23;
  std::mt19937 random(seed);
  std::cout << "seed " << seed << "\n";
  std::uniform_real_distribution<double> exponent(-1.0, 1.0);
  for (int k = 0; k < 50; ++k)
  {
    const double exact = std::pow(10.0, 3.0 * exponent(random)),
                 first = exact * std::pow(10.0, exponent(random));
    EXPECT_EQ(search(first, exact, [&](double f) { return f * f / (exact * exact); }), 2);
  }
  EXPECT_EQ(search(1e-2, 1e3, [&](double f) { return 1e-6 * f * f; }), 5); // 0.2, 4, 80, 1000
}

/// A body that stiffens or softens, and a crack that a part of the loads holds closed.
TEST(LoadFactorSearch, OfOtherBodiesConverges)
{
  EXPECT_LE(search(
                0.01, 1.0, [](double f) { return std::pow(0.5 * f + 0.5 * f * f * f, 2); }, 1e-3),
            10);
  EXPECT_LE(search(
                0.01, 1.0, [](double f) { return std::sqrt(f); }, 1e-3),
            10);
  EXPECT_LE(search(
                0.01, 4.0, [](double f) { return f > 3.0 ? std::pow(f - 3.0, 2) : 0.0; }, 1e-3),
            12);
}

/// G that jumps by a thousandth between any two equilibria is met to that.
TEST(LoadFactorSearch, OfAGThatJumpsEnds)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> jump(-1e-3, 1e-3);
  for (int k = 0; k < 20; ++k)
    EXPECT_LE(search(
                  0.9, 1.0, [&](double f) { return f * f * (1.0 + jump(random)); }, 2e-3),
              14);
}
