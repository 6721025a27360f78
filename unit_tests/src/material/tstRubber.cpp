/// Closed forms of the laws of rubber, and plane stress far from rest.

#include "Cases.hpp"

#include <limits>

namespace Rhegma
{
namespace Test
{

/// The lateral stretch that a uniaxial test needs, by bisection: it rises with tau_yy.
template <class Stress>
double lateralStretch(const Stress& lateralStress)
{
  double low = 0.3, high = 2.0;
  for (int i = 0; i < 200; ++i)
  {
    const double middle = 0.5 * (low + high);
    (lateralStress(middle) > 0.0 ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

/// Cauchy stress of a bar stretched to L with free sides, 2 (L^2 - 1/L) (C10 + C01/L) if incompressible; with
/// bulk modulus K the volume changes by sigma / 3K, a relative error of about 3e-6 here.
constexpr double c10 = 0.4e6, c01 = 0.1e6, bulk = 1.0e12, stretch = 2.0, barStress = 3.15e6;

TEST(MooneyRivlin, BarStretchedToTwoInPlaneStress)
{
  EXPECT_DOUBLE_EQ(2.0 * (stretch * stretch - 1.0 / stretch) * (c10 + c01 / stretch), barStress);
  using C = Case<MooneyRivlin, 2, Plane::Stress>;
  const Properties m = mooneyRivlin(Plane::Stress, c10, c01, bulk);
  Gradient<2> F;
  History<2> history{};
  Symmetric<2> tau;
  lateralStretch(
      [&](double s)
      {
        F = {stretch, 0.0, 0.0, s, 1.0};
        tau = stressOf<C>(m, F, history);
        return tau[1];
      });
  EXPECT_NEAR(tau[0] / determinant<2>(F.data()), barStress, 1.0e-5 * barStress);
  EXPECT_NEAR(F[3], F[4], 1.0e-9);
}

TEST(MooneyRivlin, BarStretchedToTwoInSolid)
{
  using C = Case<MooneyRivlin, 3, Plane::Solid>;
  const Properties m = mooneyRivlin(Plane::Solid, c10, c01, bulk);
  Gradient<3> F;
  History<3> history{};
  Symmetric<3> tau;
  lateralStretch(
      [&](double s)
      {
        F = {stretch, 0.0, 0.0, 0.0, s, 0.0, 0.0, 0.0, s};
        tau = stressOf<C>(m, F, history);
        return tau[1];
      });
  // K (J - 1) is the difference of numbers of K's size: 1e-16 * 1e12 Pa * a few.
  EXPECT_NEAR(tau[0] / determinant<3>(F.data()), barStress, 1.0e-5 * barStress + 1.0e-3);
}

/// W = mu/2 (I1 - 3) - mu ln J + lambda/2 (ln J)^2 under pure dilatation by s: tau = mu (s^2 - 1) + 3 lambda
/// ln s.
TEST(NeoHookean, Dilatation)
{
  using C = Case<NeoHookean, 3, Plane::Solid>;
  const Properties m = C::material();
  const double s = 0.5;
  Gradient<3> F = {s, 0.0, 0.0, 0.0, s, 0.0, 0.0, 0.0, s};
  History<3> history{};
  const Symmetric<3> tau = stressOf<C>(m, F, history);
  const double expected = m.mu * (s * s - 1.0) + 3.0 * m.lambda * std::log(s);
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(tau[i], expected, 1.0e-14 * std::fabs(expected));
}

/// The thickness is found whatever the deformation and wherever the search begins: the solid law then sees a
/// tau_zz of round-off, ten roundings of the pressure and of mu (tr g g + g g). Their g = b - 1 is of order
/// one where b is small.
template <class Law>
void checkThickness(const Properties& plane, const Properties& whole)
{
  Random random;
  for (int sample = 0; sample < 2000; ++sample)
  {
    Gradient<2> F = random.deformation<2>(0.05, 8.0);
    const Gradient<2> same = F;
    History<2> history{};
    double thickness = 0.0;
    for (const double start : {1.0, 1.0e-6, 1.0e6, 0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    {
      F = same;
      F[4] = start;
      stressOf<Case<Law, 2, Plane::Stress>>(plane, F, history);
      if (thickness == 0.0)
        thickness = F[4];
      EXPECT_NEAR(F[4], thickness, 1.0e-13 * thickness);
    }
    Gradient<3> F3 = solid(F);
    History<3> history3{};
    const Symmetric<3> tau = stressOf<Case<Law, 3, Plane::Solid>>(whole, F3, history3);
    double g[6];
    leftStrain<3>(F3.data(), g);
    const double J = determinant<3>(F3.data());
    const double size = 1.0 + 3.0 + trace<3>(g);
    const double scale = whole.bulk * (1.0 + J * J) + whole.mu * (size + std::pow(J, -2.0 / 3.0) * size +
                                                                  std::pow(J, -4.0 / 3.0) * size * size);
    EXPECT_NEAR(tau[2], 0.0, 2.0e-15 * scale);
  }
}

TEST(NeoHookean, ThicknessIsFoundFromAnywhere)
{
  for (const double poisson : {0.0, 0.3, 0.4999})
    checkThickness<NeoHookean>(hookean("Neo-Hookean", Plane::Stress, 2.6, poisson),
                               hookean("Neo-Hookean", Plane::Solid, 2.6, poisson));
}

TEST(MooneyRivlin, ThicknessIsFoundFromAnywhere)
{
  for (const double stiffness : {1.0, 20.0, 1.0e5})
    checkThickness<MooneyRivlin>(mooneyRivlin(Plane::Stress, 0.4, 0.1, stiffness),
                                 mooneyRivlin(Plane::Solid, 0.4, 0.1, stiffness));
}

} // namespace Test
} // namespace Rhegma
