#include "LatticeState.hpp"
#include "Pi.hpp"
#include "Seed.hpp"
#include "WilliamsField.hpp"
#include "material/StartOfGrowth.hpp"

#include <gtest/gtest.h>

#include <random>

using namespace Rhegma;
using namespace Rhegma::energy_release;

namespace
{

using Rhegma::Test::pi;

constexpr double angles[] = {-3.1, -2.0, -0.4, 0.0, 1.0, 2.5, pi};

CrackCompliance isotropic(double shear, double poisson, bool planeStress)
{
  const double lambda =
      planeStress ? 2.0 * shear * poisson / (1.0 - poisson) : 2.0 * shear * poisson / (1.0 - 2.0 * poisson);
  return crackCompliance({lambda + 2.0 * shear, lambda + 2.0 * shear, lambda, shear, {{1.0, 0.0}}},
                         {{0.6, 0.8}}, {{-0.8, 0.6}});
}

/// In isotropic bodies, where both roots are i, the fields are those of Williams, to rounding.
void compareWithWilliams(double poisson, bool planeStress)
{
  const double shear = 2e9, r = 3e-3;
  const CrackCompliance material = isotropic(shear, poisson, planeStress);
  const TipModuli moduli{shear, planeStress ? (3.0 - poisson) / (1.0 + poisson) : 3.0 - 4.0 * poisson};
  const double young = 2.0 * shear * (1.0 + poisson);
  const double compliance = (planeStress ? 1.0 : 1.0 - poisson * poisson) / young;
  EXPECT_NEAR(material.modeI, compliance, 1e-14 * compliance);
  EXPECT_NEAR(material.modeII, compliance, 1e-14 * compliance);
  EXPECT_NEAR(material.coupled, 0.0, 1e-14 * compliance);
  for (int mode = 0; mode < 2; ++mode)
    for (const double theta : angles)
    {
      const TipField f = TipPosition(r, theta, material).field(mode),
                     w = williamsField(mode, r, theta, moduli);
      // Some twenty roundings of numbers of order 10 times the size of the field.
      const double ofStress = 5e-14 / std::sqrt(r), ofGradient = ofStress / shear;
      for (int i = 0; i < 2; ++i)
      {
        EXPECT_NEAR(f.displacement[i], w.displacement[i], ofGradient * r) << mode << " " << theta;
        for (int j = 0; j < 2; ++j)
        {
          EXPECT_NEAR(f.stress[i][j], w.stress[i][j], ofStress) << mode << " " << theta;
          EXPECT_NEAR(f.gradient[i][j], w.gradient[i][j], ofGradient) << mode << " " << theta;
        }
      }
    }
}

/// A stiffness in the plane with moduli from 1 to 30, along random axes.
PlaneStiffness randomStiffness(std::mt19937& engine)
{
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  PlaneStiffness s;
  s.xx = std::pow(30.0, unit(engine));
  s.yy = std::pow(30.0, unit(engine));
  s.xy = (1.6 * unit(engine) - 0.8) * std::sqrt(s.xx * s.yy);
  s.shear = std::pow(30.0, unit(engine) - 0.5);
  const double angle = 2.0 * pi * unit(engine);
  s.axis = {{std::cos(angle), std::sin(angle)}};
  return s;
}

/// Stress of a strain along the axes d and n.
void stressOf(const PlaneStiffness& s, const Vector<2>& d, const Vector<2>& n, const double (&gradient)[2][2],
              double (&stress)[2][2])
{
  const Vector<2> axis = s.axis, across{{-axis[1], axis[0]}};
  // Rows: the material's axes in those of the front.
  const double R[2][2] = {{dot(axis, d), dot(axis, n)}, {dot(across, d), dot(across, n)}};
  double e[2][2] = {}, own[2][2];
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      for (int k = 0; k < 2; ++k)
        for (int l = 0; l < 2; ++l)
          e[i][j] += 0.5 * R[i][k] * R[j][l] * (gradient[k][l] + gradient[l][k]);
  own[0][0] = s.xx * e[0][0] + s.xy * e[1][1];
  own[1][1] = s.xy * e[0][0] + s.yy * e[1][1];
  own[0][1] = own[1][0] = 2.0 * s.shear * e[0][1];
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
    {
      stress[i][j] = 0.0;
      for (int k = 0; k < 2; ++k)
        for (int l = 0; l < 2; ++l)
          stress[i][j] += R[k][i] * R[l][j] * own[k][l];
    }
}

/// J of a sum of fields over a circle around the tip, by the midpoint rule, whose error falls faster than any
/// power of the number of points of a smooth integrand; that has a jump at the faces, where its slopes in
/// angle differ: the error there is that of the first ends of Gregory's rule, here of half a degree squared.
double releaseOverCircle(const CrackCompliance& material, double K1, double K2)
{
  constexpr int points = 20000;
  const double r = 0.5;
  double sum = 0.0;
  for (int k = 0; k < points; ++k)
  {
    const double theta = -pi + (k + 0.5) * 2.0 * pi / points, m[2] = {std::cos(theta), std::sin(theta)};
    const TipPosition at(r, theta, material);
    const TipField one = at.field(0), two = at.field(1);
    double energy = 0.0, work = 0.0;
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
      {
        const double s = K1 * one.stress[i][j] + K2 * two.stress[i][j];
        energy += 0.5 * s * (K1 * one.gradient[i][j] + K2 * two.gradient[i][j]);
        work += s * m[j] * (K1 * one.gradient[i][0] + K2 * two.gradient[i][0]);
      }
    sum += (energy * m[0] - work) * r * 2.0 * pi / points;
  }
  return sum;
}

} // namespace

TEST(CrackTipFields, AreThoseOfWilliamsInPlaneStrain) { compareWithWilliams(0.3, false); }
TEST(CrackTipFields, AreThoseOfWilliamsInPlaneStress) { compareWithWilliams(0.33, true); }

/// Two independent formulas of the same field; faces without traction; unit intensity ahead.
TEST(CrackTipFields, OfAnisotropicBodiesObeyHooke)
{
  std::mt19937 engine(Rhegma::Test::seed());
  for (int sample = 0; sample < 100; ++sample)
  {
    const PlaneStiffness s = randomStiffness(engine);
    const Vector<2> d{{1.0, 0.0}}, n{{0.0, sample % 2 == 0 ? 1.0 : -1.0}};
    const CrackCompliance material = crackCompliance(s, d, n);
    const double r = 0.3;
    for (int mode = 0; mode < 2; ++mode)
    {
      for (const double theta : angles)
      {
        const TipField f = TipPosition(r, theta, material).field(mode);
        double expected[2][2];
        stressOf(s, d, n, f.gradient, expected);
        double size = 0.0;
        for (int k = 0; k < 4; ++k)
          size += std::fabs(f.gradient[k / 2][k % 2]);
        for (int i = 0; i < 2; ++i)
          for (int j = 0; j < 2; ++j)
            EXPECT_NEAR(f.stress[i][j], expected[i][j], 1e-12 * (s.xx + s.yy + s.shear) * size);
      }
      for (const double theta : {-pi, pi})
      {
        const TipField face = TipPosition(r, theta, material).field(mode);
        const double scale = 1e-12 * (std::fabs(face.stress[0][0]) + 1.0);
        EXPECT_NEAR(face.stress[1][1], 0.0, scale);
        EXPECT_NEAR(face.stress[0][1], 0.0, scale);
      }
      const TipField ahead = TipPosition(r, 0.0, material).field(mode);
      EXPECT_NEAR(ahead.stress[1][mode == 0 ? 1 : 0] * std::sqrt(2.0 * pi * r), 1.0, 1e-12);
      EXPECT_NEAR(ahead.stress[1][mode == 0 ? 0 : 1], 0.0, 1e-12);
    }
  }
}

/// J = K^T H K, and the jump behind the front is that of H.
TEST(CrackTipFields, OfAnisotropicBodiesReleaseTheEnergyOfTheirMatrix)
{
  std::mt19937 engine(Rhegma::Test::seed());
  std::uniform_real_distribution<double> K(-1.0, 1.0);
  for (int sample = 0; sample < 20; ++sample)
  {
    const PlaneStiffness s = randomStiffness(engine);
    const Vector<2> d{{0.6, 0.8}}, n{{-0.8, 0.6}};
    const CrackCompliance material = crackCompliance(s, d, n);
    const double K1 = K(engine), K2 = K(engine), J = material.release(K1, K2);
    const double size = material.modeI + material.modeII;
    EXPECT_NEAR(releaseOverCircle(material, K1, K2), J, 1e-6 * size);
    EXPECT_GT(material.modeI * material.modeII, material.coupled * material.coupled);
    const double r = 0.2, factor = 8.0 * std::sqrt(r / (2.0 * pi));
    const TipPosition above(r, pi, material), below(r, -pi, material);
    for (int i = 0; i < 2; ++i)
    {
      const double jump = K1 * (above.field(0).displacement[i] - below.field(0).displacement[i]) +
                          K2 * (above.field(1).displacement[i] - below.field(1).displacement[i]);
      const double expected =
          i == 1 ? material.modeI * K1 + material.coupled * K2 : material.coupled * K1 + material.modeII * K2;
      EXPECT_NEAR(jump, factor * expected, 1e-11 * factor * size);
    }
  }
}

/// Past the faces, to which rounding may put a particle, the fields go on smoothly.
TEST(CrackTipFields, GoOnPastTheFaces)
{
  std::mt19937 engine(Rhegma::Test::seed());
  const CrackCompliance material = crackCompliance(randomStiffness(engine), {{1.0, 0.0}}, {{0.0, 1.0}});
  for (const double side : {-1.0, 1.0})
    for (int mode = 0; mode < 2; ++mode)
    {
      const TipField before = TipPosition(1.0, side * (pi - 1e-7), material).field(mode),
                     behind = TipPosition(1.0, side * (pi + 1e-7), material).field(mode);
      for (int i = 0; i < 2; ++i)
        EXPECT_NEAR(before.displacement[i], behind.displacement[i],
                    1e-5 * (std::fabs(before.displacement[i]) + material.a11 + material.a22));
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
