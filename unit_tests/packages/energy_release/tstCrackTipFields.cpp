#include "LatticeState.hpp"
#include "Pi.hpp"
#include "material/StartOfGrowth.hpp"

#include <gtest/gtest.h>

using namespace Rhegma;
using namespace Rhegma::energy_release;

namespace
{

using Rhegma::Test::pi;

/// Stress must follow from the gradient by Hooke's law: two independent formulas of the same field.
void checkHooke(double poisson, bool planeStress)
{
  const double shear = 2e9, r = 3e-3;
  const double lambda =
      planeStress ? 2.0 * shear * poisson / (1.0 - poisson) : 2.0 * shear * poisson / (1.0 - 2.0 * poisson);
  const TipModuli moduli{shear, planeStress ? (3.0 - poisson) / (1.0 + poisson) : 3.0 - 4.0 * poisson};
  for (int mode = 0; mode < 2; ++mode)
    for (const double theta : {-3.1, -2.0, -0.4, 0.0, 1.0, 2.5, pi})
    {
      const TipField f = williamsField(mode, r, theta, moduli);
      const double roundOff = 1e-14 / std::sqrt(r);
      const double pressure = lambda * (f.gradient[0][0] + f.gradient[1][1]);
      EXPECT_NEAR(f.stress[0][0], pressure + 2.0 * shear * f.gradient[0][0], roundOff)
          << mode << " " << theta;
      EXPECT_NEAR(f.stress[1][1], pressure + 2.0 * shear * f.gradient[1][1], roundOff)
          << mode << " " << theta;
      EXPECT_NEAR(f.stress[0][1], shear * (f.gradient[0][1] + f.gradient[1][0]), roundOff)
          << mode << " " << theta;
    }
}

} // namespace

TEST(CrackTipFields, StressFollowsFromStrainInPlaneStrain) { checkHooke(0.3, false); }
TEST(CrackTipFields, StressFollowsFromStrainInPlaneStress) { checkHooke(0.33, true); }

TEST(CrackTipFields, FacesAreFreeAndUnitIntensityIsAhead)
{
  const TipModuli moduli{1e9, 1.8};
  const double r = 2e-3;
  for (int mode = 0; mode < 2; ++mode)
  {
    for (const double theta : {-pi, pi})
    {
      const TipField face = williamsField(mode, r, theta, moduli);
      EXPECT_NEAR(face.stress[1][1], 0.0, 1e-13);
      EXPECT_NEAR(face.stress[0][1], 0.0, 1e-13);
    }
    const TipField ahead = williamsField(mode, r, 0.0, moduli);
    EXPECT_NEAR(ahead.stress[1][mode == 0 ? 1 : 0] * std::sqrt(2.0 * pi * r), 1.0, 1e-14);
  }
}

/// Values in closed form: tan(kink / 2) of K_I = K_II is -1/2, and cos(kink) of pure sliding is 1/3.
TEST(CrackTipFields, KinkFollowsTheLargestHoopStress)
{
  EXPECT_EQ(hoopStressAngle(2.0, 0.0), 0.0);
  EXPECT_NEAR(hoopStressAngle(1.0, 1.0), -2.0 * std::atan(0.5), 1e-15);
  EXPECT_NEAR(hoopStressAngle(1.0, -1.0), 2.0 * std::atan(0.5), 1e-15);
  EXPECT_NEAR(std::cos(hoopStressAngle(0.0, 3.0)), 1.0 / 3.0, 1e-15);
  EXPECT_LT(hoopStressAngle(0.0, 3.0), 0.0);
}
