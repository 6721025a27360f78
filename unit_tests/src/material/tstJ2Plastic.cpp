/// The J2 law where it yields.

#include "Cases.hpp"

namespace Rhegma
{
namespace Test
{

template <int D>
double deviatorNorm(Symmetric<D> tau)
{
  const double mean = trace<D>(tau.data()) / 3.0;
  for (int i = 0; i < 3; ++i)
    tau[normalIndex<D>(i)] -= mean;
  return std::sqrt(squaredNorm<D>(tau.data()));
}

template <int D>
Symmetric<D> plasticDeformation(const History<D>& history)
{
  Symmetric<D> c;
  for (int i = 0; i < symmetricSize<D>; ++i)
    c[i] = history[i];
  for (int i = 0; i < 3; ++i)
    c[normalIndex<D>(i)] += 1.0;
  return c;
}

template <class C>
struct J2 : testing::Test
{
};
using J2Cases = testing::Types<Case<J2Plastic, 2, Plane::Strain>, Case<J2Plastic, 2, Plane::Stress>,
                               Case<J2Plastic, 3, Plane::Solid>>;
TYPED_TEST_SUITE(J2, J2Cases);

/// A smooth path that stretches, shears and turns.
template <int D>
Gradient<D> pathAt(double t)
{
  std::array<double, D> a{}, b{};
  a[0] = 1.0;
  b[1] = 1.0;
  Gradient<D> F = multiply<D>(dyad<D>(0.35 * std::sin(2.0 * t), a, b), dyad<D>(0.3 * t, a, a));
  F = multiply<D>(dyad<D>(-0.1 * t * t, b, b), F);
  if constexpr (D == 3)
    F = multiply<3>(dyad<3>(0.2 * std::sin(3.0 * t), {0.6, 0.0, 0.8}, {0.0, 1.0, 0.0}), F);
  const double angle = 1.5 * t;
  Gradient<D> Q = identity<D>();
  Q[0] = Q[D + 1] = std::cos(angle);
  Q[1] = -std::sin(angle);
  Q[D] = std::sin(angle);
  return multiply<D>(Q, F);
}

/// On the yield surface after every plastic step, with plastic flow that keeps the volume, alpha and
/// dissipation that only grow; 20 roundings a step.
TYPED_TEST(J2, StaysOnTheYieldSurface)
{
  constexpr int D = TypeParam::D;
  const Properties m = plastic(TypeParam::P, 2.6, 0.3, 0.02, 0.05, 0.05, 8.0);
  History<D> history{};
  Gradient<D> F = identity<D>();
  const int steps = 400;
  int yielded = 0;
  for (int s = 1; s <= steps; ++s)
  {
    const double thickness = F[4];
    F = pathAt<D>(2.0 * s / steps);
    if (D == 2 && TypeParam::P == Plane::Stress)
      F[4] = thickness;
    const History<D> before = history;
    const Symmetric<D> tau = stressOf<TypeParam>(m, F, history);
    const double limit = yieldNorm(m, history[J2Plastic::plasticStrainIndex<D>]);
    EXPECT_LE(deviatorNorm<D>(tau), limit * (1.0 + 1.0e-12));
    if (history[J2Plastic::plasticStrainIndex<D>] > before[J2Plastic::plasticStrainIndex<D>])
    {
      ++yielded;
      EXPECT_NEAR(deviatorNorm<D>(tau), limit, 1.0e-12 * limit);
      EXPECT_GT(history[J2Plastic::dissipationIndex<D>], before[J2Plastic::dissipationIndex<D>]);
    }
    else
    {
      EXPECT_EQ(history, before);
    }
    EXPECT_NEAR(symmetricDeterminant<D>(plasticDeformation<D>(history).data()), 1.0, 20.0 * 1.2e-16 * s);
  }
  EXPECT_GT(yielded, steps / 2);
}

/// What the stress does on the path is stored or dissipated: the trapezoidal sum of tau : d along a smooth
/// path misses the sum of both by a fraction that falls with the steps, at first order because the return is
/// backward Euler.
template <class C>
double workError(int steps, const Properties& m)
{
  constexpr int D = C::D;
  History<D> history{};
  Gradient<D> F = identity<D>();
  Symmetric<D> tau{};
  double work = 0.0;
  for (int s = 1; s <= steps; ++s)
  {
    const Gradient<D> before = F;
    const Symmetric<D> old = tau;
    F = pathAt<D>(1.5 * s / steps);
    if constexpr (D == 2)
      if (C::P == Plane::Stress)
        F[4] = before[4];
    tau = stressOf<C>(m, F, history);
    // Increment of displacement gradient on the middle of the step: (F1 - F0) ((F0 + F1)/2)^-1.
    Gradient<D> middle, change, inverted;
    for (int i = 0; i < gradientSize<D>; ++i)
    {
      middle[i] = 0.5 * (before[i] + F[i]);
      change[i] = F[i] - before[i];
    }
    inverse<D>(middle.data(), determinant<D>(middle.data()), inverted.data());
    const Gradient<D> gradient = multiply<D>(change, inverted);
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
      {
        const int c = symmetricIndex<D>(i, j);
        work += 0.5 * (old[c] + tau[c]) * gradient[i * D + j];
      }
  }
  const double stored = C::Law::template energy<D, C::P>(m, F.data(), history.data());
  EXPECT_GT(history[J2Plastic::dissipationIndex<D>], stored);
  return (work - stored - history[J2Plastic::dissipationIndex<D>]) / work;
}

TYPED_TEST(J2, WorkIsStoredOrDissipated)
{
  for (const double rate : {0.0, 8.0})
  {
    const Properties m = plastic(TypeParam::P, 2.6, 0.3, 0.1, 0.05, rate > 0.0 ? 0.15 : 0.0, rate);
    const double coarse = std::fabs(workError<TypeParam>(1000, m));
    const double fine = std::fabs(workError<TypeParam>(4000, m));
    EXPECT_LT(coarse, 2.0e-3);
    EXPECT_LT(fine, coarse / 3.0 + 1.0e-6);
  }
}

/// Unloading is elastic: the history does not change, and a closed elastic loop restores the stress.
TYPED_TEST(J2, UnloadsElastically)
{
  constexpr int D = TypeParam::D;
  const Properties m = plastic(TypeParam::P, 2.6, 0.3, 0.02, 0.05);
  History<D> history{};
  Gradient<D> F = identity<D>();
  F[0] = 1.2;
  const Gradient<D> loaded = F;
  const Symmetric<D> top = stressOf<TypeParam>(m, F, history);
  const History<D> after = history;
  EXPECT_GT(after[J2Plastic::plasticStrainIndex<D>], 0.1);
  for (const double stretch : {1.199, 1.195, 1.192})
  {
    F[0] = stretch;
    const Symmetric<D> tau = stressOf<TypeParam>(m, F, history);
    EXPECT_EQ(history, after);
    // Elastic slope with corrections of the order of strain since the start, here 20 %.
    const double modulus = elasticity(m).constrainedModulus;
    EXPECT_NEAR((top[0] - tau[0]) / (1.2 - stretch) / modulus, 1.0, 0.25);
  }
  F = loaded;
  const Symmetric<D> again = stressOf<TypeParam>(m, F, history);
  for (int i = 0; i < symmetricSize<D>; ++i)
    EXPECT_NEAR(again[i], top[i], 1.0e-14);
}

/// A rotation on top of the whole path rotates the stress and does not change the history. Round-off grows
/// over the steps.
TYPED_TEST(J2, HistoryDoesNotSeeRotation)
{
  constexpr int D = TypeParam::D;
  const Properties m = plastic(TypeParam::P, 2.6, 0.3, 0.02, 0.05);
  Random random;
  History<D> history{}, turnedHistory{};
  const int steps = 100;
  for (int s = 1; s <= steps; ++s)
  {
    Gradient<D> F = pathAt<D>(2.0 * s / steps);
    const Gradient<D> Q = random.rotation<D>();
    Gradient<D> turned = multiply<D>(Q, F);
    const Symmetric<D> expected = rotate<D>(Q, stressOf<TypeParam>(m, F, history));
    const Symmetric<D> tau = stressOf<TypeParam>(m, turned, turnedHistory);
    for (int i = 0; i < symmetricSize<D>; ++i)
      EXPECT_NEAR(tau[i], expected[i], 1.0e-14 * s + 1.0e-14);
    for (unsigned i = 0; i < history.size(); ++i)
      EXPECT_NEAR(turnedHistory[i], history[i], 1.0e-14 * s + 1.0e-14);
  }
}

/// Plane stress is the solid at the thickness that it finds, plastic steps included, from a start far off
/// too.
TEST(J2PlaneStress, AgreesWithSolid)
{
  const Properties m = plastic(Plane::Stress, 2.6, 0.3, 0.02, 0.05, 0.06, 5.0);
  const Properties m3 = plastic(Plane::Solid, 2.6, 0.3, 0.02, 0.05, 0.06, 5.0);
  History<2> history{};
  History<3> history3{};
  const int steps = 40;
  for (int s = 1; s <= steps; ++s)
  {
    Gradient<2> F = pathAt<2>(2.0 * s / steps);
    F[4] = s % 2 == 0 ? 30.0 : 1.0;
    const Symmetric<3> tau = solid(stressOf<Case<J2Plastic, 2, Plane::Stress>>(m, F, history));
    Gradient<3> F3 = solid(F);
    const Symmetric<3> expected = stressOf<Case<J2Plastic, 3, Plane::Solid>>(m3, F3, history3);
    for (int i = 0; i < 6; ++i)
      EXPECT_NEAR(tau[i], expected[i], 1.0e-13) << s;
    EXPECT_NEAR(history[J2Plastic::plasticStrainIndex<2>], history3[J2Plastic::plasticStrainIndex<3>],
                1.0e-13);
    EXPECT_NEAR(history[J2Plastic::dissipationIndex<2>], history3[J2Plastic::dissipationIndex<3>], 1.0e-13);
  }
}

/// A bar with free sides, pulled in `steps` steps; the lateral stretch by bisection in plane stress.
struct Bar
{
  double stress, plasticStrain, dissipated, stored;
};

Bar pullBar(const Properties& m, double strain, int steps)
{
  using C = Case<J2Plastic, 2, Plane::Stress>;
  History<2> history{};
  Gradient<2> F = identity<2>();
  Symmetric<2> tau{};
  for (int s = 1; s <= steps; ++s)
  {
    const History<2> before = history;
    const double reach = strain * s / steps;
    double low = -reach, high = reach;
    for (int i = 0; i < 100; ++i)
    {
      const double middle = 0.5 * (low + high);
      history = before;
      F = {1.0 + reach, 0.0, 0.0, 1.0 + middle, F[4]};
      tau = stressOf<C>(m, F, history);
      (tau[1] > 0.0 ? high : low) = middle;
    }
  }
  return {tau[0], history[J2Plastic::plasticStrainIndex<2>], history[J2Plastic::dissipationIndex<2>],
          C::Law::energy<2, Plane::Stress>(m, F.data(), history.data())};
}

/// Small strain with linear hardening: stress Y + E H / (E + H) (e - Y/E), dissipation (Y + H alpha / 2)
/// alpha, stored stress^2 / 2E. Strains of 1e-5 leave a relative error of 1e-5 times a few, round-off 1e-16 /
/// 1e-6.
TEST(J2Bar, LinearHardening)
{
  const double young = 2.0e11, yield = 2.0e5, hardening = 4.0e10, strain = 1.0e-5;
  const Properties m = plastic(Plane::Stress, young, 0.3, yield, hardening);
  const double before = pullBar(m, 0.9e-6, 1).plasticStrain;
  EXPECT_EQ(before, 0.0);
  for (const int steps : {1, 7})
  {
    const Bar bar = pullBar(m, strain, steps);
    const double stress = yield + young * hardening / (young + hardening) * (strain - yield / young);
    const double alpha = strain - stress / young;
    EXPECT_NEAR(bar.stress / stress, 1.0, 5.0e-5);
    EXPECT_NEAR(bar.plasticStrain / alpha, 1.0, 5.0e-5);
    EXPECT_NEAR(bar.dissipated / ((yield + 0.5 * hardening * alpha) * alpha), 1.0, 1.0e-4);
    EXPECT_NEAR(bar.stored / (0.5 * stress * stress / young), 1.0, 1.0e-4);
  }
}

/// Voce: stress = sigma_y(e - stress / E), with sigma_y = Y + (S - Y)(1 - exp(-r alpha)), solved by
/// repetition.
TEST(J2Bar, Saturation)
{
  const double young = 2.0e11, yield = 2.0e5, saturated = 4.0e5, rate = 5.0e5, strain = 1.0e-5;
  const Properties m = plastic(Plane::Stress, young, 0.3, yield, 0.0, saturated, rate);
  double stress = yield;
  for (int i = 0; i < 200; ++i)
    stress =
        0.5 * stress + 0.5 * (yield - (saturated - yield) * std::expm1(-rate * (strain - stress / young)));
  const Bar bar = pullBar(m, strain, 20);
  EXPECT_GT(stress, 1.5 * yield);
  EXPECT_NEAR(bar.stress / stress, 1.0, 5.0e-5);
}

/// Perfect plasticity sheared by gamma: tau_xy = Y / sqrt(3) and alpha = (gamma - elastic part) / sqrt(3),
/// both to Y/mu = 0.3 %, and the stress work is tau gamma.
TEST(J2Shear, ByTwo)
{
  using C = Case<J2Plastic, 3, Plane::Solid>;
  const Properties m = plastic(Plane::Solid, 2.6, 0.3, 0.003, 0.0);
  History<3> history{};
  Symmetric<3> tau{};
  const double gamma = 2.0;
  const int steps = 2000;
  for (int s = 1; s <= steps; ++s)
  {
    Gradient<3> F = identity<3>();
    F[1] = gamma * s / steps;
    tau = stressOf<C>(m, F, history);
  }
  const double shear = m.own[J2Number::yield] / std::sqrt(3.0);
  EXPECT_NEAR(tau[3] / shear, 1.0, 0.003);
  EXPECT_NEAR(history[J2Plastic::plasticStrainIndex<3>] / ((gamma - shear / m.mu) / std::sqrt(3.0)), 1.0,
              0.003);
  EXPECT_NEAR(history[J2Plastic::dissipationIndex<3>] / (shear * gamma), 1.0, 0.003);
}

} // namespace Test
} // namespace Rhegma
