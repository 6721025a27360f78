/// The integral of the gradient of temperature over the cells at a front, against closed forms.

#include "energy_release/HeatNearFront.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

using Rhegma::energy_release::HeatNearFront;

namespace
{

const double halfTurn = 4.0 * std::atan(1.0);

/// r f, of a radius and an angle.
using Density = std::function<double(double r, double theta)>;

/// Sums over 2 x 2 particles in each cell of 1 m, with the front anywhere in its cell and the crack at any
/// angle; the weight q is 1.
struct Sums
{
  double of[HeatNearFront::numSums] = {};
  double all = 0.0; ///< sum w f without a correction

  Sums(const HeatNearFront& near, std::mt19937& random, const Density& density)
  {
    std::uniform_real_distribution<double> in01;
    const double x = in01(random), y = in01(random), turn = 2.0 * halfTurn * in01(random);
    for (int i = -12; i <= 12; ++i)
      for (int j = -12; j <= 12; ++j)
      {
        const double dx = 0.5 * i + 0.25 - 0.5 * x, dy = 0.5 * j + 0.25 - 0.5 * y, r = std::hypot(dx, dy);
        const double theta = std::remainder(std::atan2(dy, dx) - turn, 2.0 * halfTurn);
        if (near.reaches(r))
          near.add(r, 0.25 * density(r, theta) / r, 1.0, of);
      }
    all = of[0];
  }
};

/// Largest errors with the fit and without, over the exact integral, at 100 random places.
std::pair<double, double> worstErrors(double power, const Density& density, double exact)
{
  std::mt19937 random(20);
  const HeatNearFront near(1.0, 3.0, 6.0);
  double fitted = 0.0, summed = 0.0;
  for (int k = 0; k < 100; ++k)
  {
    const Sums sums(near, random, density);
    fitted = std::max(fitted, std::fabs(near.near(sums.of, power) / exact - 1.0));
    summed = std::max(summed, std::fabs(sums.all / exact - 1.0));
  }
  std::cout << "largest error with the fit " << fitted << ", of the sum over particles " << summed << "\n";
  return {fitted, summed};
}

} // namespace

/// Two singular fields: r f = sin^2(theta / 2) (1 + r / 16), as of mode II and the temperature of a crack of
/// 8 cells. With w = 1 up to r = 1 and 2 - r up to 2: int w = 3/2, int w r = 7/6. The moments are sums over
/// some 200 particles with weights that vanish quadratically in the cell at both ends of the ring: half a
/// percent, which the extrapolation to the front multiplies by up to ten.
TEST(HeatNearFront, TwoSingularFields)
{
  const double exact = halfTurn * (1.5 + 7.0 / 6.0 / 16.0);
  const auto [fitted, summed] = worstErrors(
      1.0, [](double r, double theta) { return std::pow(std::sin(theta / 2.0), 2) * (1.0 + r / 16.0); },
      exact);
  EXPECT_LT(fitted, 0.05);
  EXPECT_GT(summed, 0.05); // else there would be nothing to correct
}

/// The stress of mode I in a uniform gradient along the crack: r f = sqrt(r) cos(theta / 2), whose mean over
/// the circle is 2 sqrt(r) / pi. int w sqrt(r) = 2/3 + [4/3 r^(3/2) - 2/5 r^(5/2)] from 1 to 2.
TEST(HeatNearFront, ModeIInAUniformGradient)
{
  const double root = std::sqrt(2.0);
  const double radial = 2.0 / 3.0 + (8.0 / 3.0 * root - 8.0 / 5.0 * root) - (4.0 / 3.0 - 2.0 / 5.0);
  const auto [fitted, summed] = worstErrors(
      0.5, [](double r, double theta) { return std::sqrt(r) * std::cos(theta / 2.0); }, 4.0 * radial);
  EXPECT_LT(fitted, 0.05);
  EXPECT_GT(summed, fitted);
}

/// Faces that are held at a temperature, in mode I: r f = cos^2(theta / 2), and a uniform
/// gradient.
TEST(HeatNearFront, ModeIWithHeldFaces)
{
  const double root = std::sqrt(2.0);
  const double radial = 2.0 / 3.0 + (8.0 / 3.0 * root - 8.0 / 5.0 * root) - (4.0 / 3.0 - 2.0 / 5.0);
  const auto [fitted, summed] = worstErrors(
      0.5,
      [](double r, double theta)
      { return std::pow(std::cos(theta / 2.0), 2) + 0.3 * std::sqrt(r) * std::cos(theta / 2.0); },
      halfTurn * 1.5 + 0.3 * 4.0 * radial);
  EXPECT_LT(fitted, 0.05);
  EXPECT_GT(summed, 0.05);
}

/// A uniform integrand of 3 without singularity gives 3 2 pi int w r, by the first moment alone too.
TEST(HeatNearFront, RegularRemainder)
{
  const double exact = 3.0 * 2.0 * halfTurn * 7.0 / 6.0;
  const Density density = [](double r, double) { return 3.0 * r; };
  EXPECT_LT(worstErrors(1.0, density, exact).first, 0.05);
  std::mt19937 random(21);
  const HeatNearFront near(1.0, 3.0, 6.0);
  for (int k = 0; k < 20; ++k)
    EXPECT_NEAR(near.nearOfRemainder(Sums(near, random, density).of, false) / exact, 1.0, 0.02);
}

TEST(HeatNearFront, SmallContoursAreNotCorrected)
{
  EXPECT_TRUE(HeatNearFront(1.0, 2.0, 3.0).corrects());
  EXPECT_FALSE(HeatNearFront(1.0, 1.9, 6.0).corrects());
  EXPECT_FALSE(HeatNearFront(1.0, 2.5, 2.9).corrects());
  EXPECT_FALSE(HeatNearFront().corrects());
}
