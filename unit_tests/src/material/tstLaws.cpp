/// Properties of every law, in every plane.

#include "Cases.hpp"

#include <limits>

namespace Rhegma
{
namespace Test
{

template <class C>
struct Laws : testing::Test
{
};
TYPED_TEST_SUITE(Laws, EveryCase);

TYPED_TEST(Laws, UndeformedIsFree)
{
  constexpr int D = TypeParam::D;
  const Properties m = TypeParam::material();
  Gradient<D> F = identity<D>();
  History<D> history{};
  for (const double component : stressOf<TypeParam>(m, F, history))
    EXPECT_EQ(component, 0.0);
  EXPECT_EQ((TypeParam::Law::template energy<D, TypeParam::P>(m, F.data(), history.data())), 0.0);
  EXPECT_EQ(F, identity<D>());
}

/// dW = tau : grad du for every component of grad du. The differences leave step^4 W^(5) / 30, with stretches
/// of 0.7 to 1.4 and p = 20 at most 1e-12 * 20 * 5! / 0.5^5 / 30, and round-off of W / step below 1e-12.
TYPED_TEST(Laws, StressIsTheSlopeOfTheEnergy)
{
  constexpr int D = TypeParam::D;
  const Properties m = TypeParam::material();
  Random random;
  for (int sample = 0; sample < 50; ++sample)
  {
    Gradient<D> F = random.deformation<D>(0.7, 1.4);
    History<D> history{};
    const Symmetric<D> tau = stressOf<TypeParam>(m, F, history);
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
      {
        std::array<double, D> ei{}, ej{};
        ei[i] = ej[j] = 1.0;
        const double slope = slopeAtZero(
            [&](double e) { return energyOf<TypeParam>(m, multiply<D>(dyad<D>(e, ei, ej), F), history); },
            1.0e-3);
        EXPECT_NEAR(slope, tau[symmetricIndex<D>(i, j)], 3.0e-9) << i << j;
      }
    if constexpr (TypeParam::P == Plane::Strain)
    {
      const double slope = slopeAtZero(
          [&](double e)
          {
            Gradient<D> thicker = F;
            thicker[4] *= 1.0 + e;
            return energyOf<TypeParam>(m, thicker, history);
          },
          1.0e-3);
      EXPECT_NEAR(slope, tau[3], 3.0e-9);
    }
  }
}

/// Twenty roundings of numbers up to the largest modulus (20) times b^2 (16).
TYPED_TEST(Laws, StressTurnsWithTheMaterial)
{
  constexpr int D = TypeParam::D;
  const Properties m = TypeParam::material();
  Random random;
  for (int sample = 0; sample < 50; ++sample)
  {
    Gradient<D> F = random.deformation<D>(0.6, 1.5);
    const Gradient<D> Q = random.rotation<D>();
    Gradient<D> turned = multiply<D>(Q, F);
    History<D> history{};
    const Symmetric<D> expected = rotate<D>(Q, stressOf<TypeParam>(m, F, history));
    const Symmetric<D> tau = stressOf<TypeParam>(m, turned, history);
    for (int i = 0; i < symmetricSize<D>; ++i)
      EXPECT_NEAR(tau[i], expected[i], 2.0e-12);
    EXPECT_NEAR((TypeParam::Law::template energy<D, TypeParam::P>(m, F.data(), history.data())),
                (TypeParam::Law::template energy<D, TypeParam::P>(m, turned.data(), history.data())),
                2.0e-12);
  }
}

/// Hooke's law of isotropic materials up to terms of second order: strain 1e-7, so 1e-14 times moduli of 20
/// and a count of products.
TYPED_TEST(Laws, SmallStrainIsHooke)
{
  constexpr int D = TypeParam::D;
  if (isAnisotropicLaw<typename TypeParam::Law>) // tstOrthotropic.cpp
    return;
  const Properties m = TypeParam::material();
  const Elasticity e = elasticity(m);
  const double lambda = TypeParam::P == Plane::Stress
                            ? e.young * e.poisson / (1.0 - e.poisson * e.poisson)
                            : e.young * e.poisson / (1.0 + e.poisson) / (1.0 - 2.0 * e.poisson);
  Random random;
  Gradient<D> A{};
  for (int i = 0; i < D * D; ++i)
    A[i] = random.between(-1.0e-7, 1.0e-7);
  Gradient<D> F = identity<D>();
  double dilatation = 0.0;
  for (int i = 0; i < D * D; ++i)
    F[i] += A[i];
  for (int d = 0; d < D; ++d)
    dilatation += A[d * D + d];
  History<D> history{};
  const Symmetric<D> tau = stressOf<TypeParam>(m, F, history);
  const double secondOrder = 1.0e-12;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j)
      EXPECT_NEAR(tau[symmetricIndex<D>(i, j)],
                  (i == j ? lambda * dilatation : 0.0) + e.shear * (A[i * D + j] + A[j * D + i]),
                  secondOrder);
  if constexpr (TypeParam::P == Plane::Strain)
  {
    EXPECT_NEAR(tau[3], lambda * dilatation, secondOrder);
  }
  if constexpr (TypeParam::P == Plane::Stress)
  {
    EXPECT_NEAR(F[4] - 1.0, -e.poisson / (1.0 - e.poisson) * dilatation, secondOrder);
  }
}

/// A 2D law agrees with the same law in three dimensions, and in plane stress the latter finds no tau_zz.
TYPED_TEST(Laws, PlaneAgreesWithSolid)
{
  if constexpr (TypeParam::D == 2)
  {
    using Solid = Case<typename TypeParam::Law, 3, Plane::Solid>;
    const Properties m = TypeParam::material();
    const Properties m3 = Solid::material();
    Random random;
    for (int sample = 0; sample < 100; ++sample)
    {
      Gradient<2> F = random.deformation<2>(0.6, 1.35);
      History<2> history{};
      History<3> history3{};
      const Symmetric<3> tau = solid(stressOf<TypeParam>(m, F, history));
      Gradient<3> F3 = solid(F);
      const Symmetric<3> expected = stressOf<Solid>(m3, F3, history3);
      for (int i = 0; i < 6; ++i)
        EXPECT_NEAR(tau[i], expected[i], 2.0e-12) << i;
      EXPECT_NEAR((TypeParam::Law::template energy<2, TypeParam::P>(m, F.data(), history.data())),
                  (Solid::Law::template energy<3, Plane::Solid>(m3, F3.data(), history3.data())), 2.0e-12);
      if constexpr (TypeParam::P == Plane::Stress)
      {
        EXPECT_EQ(tau[2], 0.0);
      }
    }
  }
}

TYPED_TEST(Laws, InvertedIsRefused)
{
  constexpr int D = TypeParam::D;
  const Properties m = TypeParam::material();
  for (const double bad : {-1.0, 0.0, std::numeric_limits<double>::quiet_NaN()})
  {
    Gradient<D> F = identity<D>();
    F[0] = bad;
    History<D> history{};
    Symmetric<D> tau;
    tau.fill(7.0);
    EXPECT_FALSE((TypeParam::Law::template stress<D, TypeParam::P>(m, F.data(), tau.data(), history.data())));
    for (const double component : tau)
      EXPECT_EQ(component, 0.0);
    for (const double number : history)
      EXPECT_EQ(number, 0.0);
  }
}

/// Energy keeps its digits at small strain, where W is of order strain^2: 1e-8 strain, 1e-16 energy.
TYPED_TEST(Laws, EnergyOfSmallStrainKeepsItsDigits)
{
  constexpr int D = TypeParam::D;
  const Properties m = TypeParam::material();
  const double strain = 1.0e-8;
  Gradient<D> F = identity<D>();
  F[0] += strain;
  const double modulus =
      isAnisotropicLaw<typename TypeParam::Law> ? m.own[0] : elasticity(m).constrainedModulus;
  // The rounding of 1 + strain is 1e-16 / 1e-8 of it, and enters W twice.
  EXPECT_NEAR(energyOf<TypeParam>(m, F, {}) / (0.5 * modulus * strain * strain), 1.0, 2.0e-7);
}

} // namespace Test
} // namespace Rhegma
