/// The law High-Rate Solid against integrated equations, against J2 Plastic, and in extreme states.

#include "HighRateCase.hpp"

#include <algorithm>

namespace Rhegma
{
namespace Test
{

namespace
{

/// From F = 1: stretch, shear and compression of some tenths, with a reversal.
Matrix deformedAt(double t)
{
  const Matrix shear = {1.0, 0.25 * std::sin(4.0 * t), 0.0, 0.0, 1.0, 0.1 * t, 0.0, 0.0, 1.0};
  const Matrix stretch = {1.0 + 0.15 * t, 0.0, 0.0, 0.0, 1.0 - 0.2 * t, 0.0, 0.0, 0.0, 1.0 - 0.04 * t};
  return times(shear, stretch);
}

struct Outcome
{
  Symmetric<3> tau{};
  LongHistory history{};
  Matrix F = one;
  double work = 0.0; ///< trapezoidal [J/m3]
};

Outcome deform(const Properties& m, double duration, int steps)
{
  Outcome now;
  for (int s = 1; s <= steps; ++s)
  {
    const Matrix before = now.F;
    const Symmetric<3> old = now.tau;
    now.F = deformedAt(static_cast<double>(s) / steps);
    EXPECT_TRUE((updateStress<3>(LawStep{before.data(), duration / steps, m.temperature}, m, now.F.data(),
                                 now.tau.data(), now.history.data())));
    const Matrix L = times(sumOf(1.0, now.F, -1.0, before), inverted(sumOf(0.5, now.F, 0.5, before)));
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        now.work += 0.5 * (now.tau[symmetricIndex<3>(i, j)] + old[symmetricIndex<3>(i, j)]) * L[3 * i + j];
  }
  return now;
}

/// Three rates at three temperatures, with and without shock pressure: stress, warming and dissipation within
/// 0.1 % of the equations, integrated with steps of a twentieth of the time in which the stress relaxes.
TEST(HighRateSolid, FollowsTheIntegratedEquations)
{
  for (const bool shocked : {false, true})
    for (const double temperature : {293.0, 500.0, 800.0})
      for (const double rate : {1.0, 1e3, 1e5})
      {
        Metal p = randomMetal(static_cast<unsigned>(temperature + rate) + (shocked ? 7u : 0u));
        p.shocked = shocked;
        p.temperature = temperature;
        const double duration = 1.0 / rate;
        const auto path = [&](double t) { return deformedAt(t / duration); };
        MetalState y{};
        y[0] = y[4] = y[8] = 1.0;
        y[10] = temperature;
        y = integrate([&](double t, const MetalState& at) { return rateOf(p, path, t, at, 1e-6 * duration); },
                      y, duration, 60000);
        const Outcome found = deform(p.properties(Plane::Solid), duration, 20000);
        const Matrix expected = stressOf(p, found.F, y);
        const Matrix part = deviator(expected);
        const double largest = std::sqrt(doubleProduct(part, part));
        Matrix tau{};
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            tau[3 * i + j] = found.tau[symmetricIndex<3>(i, j)];
        const Matrix difference = deviator(sumOf(1.0, tau, -1.0, expected));
        EXPECT_LT(std::sqrt(doubleProduct(difference, difference)), 1e-3 * largest)
            << rate << " 1/s, " << temperature << " K";
        EXPECT_NEAR(traceOf(tau) / traceOf(expected), 1.0, 1e-3);
        EXPECT_NEAR(found.history[6] / y[9], 1.0, 1e-3);
        EXPECT_NEAR(found.history[7] / y[12], 1.0, 1e-3);
        EXPECT_NEAR(found.history[8] / (y[10] - temperature), 1.0, 1e-3);
      }
}

/// What the stress does is stored or dissipated, artificial viscosity included: of first order in the steps
/// where the material flows.
TEST(HighRateSolid, StoresOrDissipatesItsWork)
{
  for (const bool shocked : {false, true})
  {
    Metal p = randomMetal(90u + shocked);
    p.shocked = shocked;
    p.linear = 0.2;
    p.quadratic = 2.0;
    Properties m = p.properties(Plane::Solid);
    m.cellSize = 1e-3;
    const auto error = [&](int steps)
    {
      const Outcome at = deform(m, 1e-5, steps);
      EXPECT_GT(at.history[7], 0.0);
      return std::fabs((storedEnergy<3>(m, at.F.data(), at.history.data()) + at.history[7]) / at.work - 1.0);
    };
    EXPECT_LT(error(2000), 1e-4);
    EXPECT_LT(error(2000), 0.6 * error(1000));
  }
}

/// With neither rate nor heat it is J2 Plastic, in every plane.
template <int D, Plane P>
void expectJ2()
{
  const double A = 0.02, H = 0.05, Q = 0.03, b = 8.0;
  const Properties old = plastic(P, 2.6, 0.3, A, H, A + Q, b);
  Metal p;
  p.density = 2.0;
  p.young = 2.6;
  p.poisson = 0.3;
  p.A = A;
  p.B = H;
  p.n = 1.0;
  p.C = p.m = p.capacity = 0.0;
  p.voce = Q;
  p.voceRate = b;
  const Properties m = p.properties(P);
  LongHistory ours{}, theirs{};
  Random random;
  Gradient<D> before = identity<D>();
  for (int s = 0; s < 200; ++s)
  {
    Gradient<D> F = random.deformation<D>(0.8, 1.25);
    F[gradientSize<D> - 1] = D == 2 ? before[gradientSize<D> - 1] : F[gradientSize<D> - 1];
    Gradient<D> other = F;
    Symmetric<D> a{}, expected{};
    ASSERT_TRUE((updateStress<D>(LawStep{before.data(), 1.0, 293.0}, m, F.data(), a.data(), ours.data())));
    ASSERT_TRUE((updateStress<D>(LawStep{before.data(), 1.0, 293.0}, old, other.data(), expected.data(),
                                 theirs.data())));
    for (int k = 0; k < symmetricSize<D>; ++k)
      EXPECT_NEAR(a[k], expected[k], 1e-11);
    for (int k = 0; k < symmetricSize<D> + 2; ++k)
      EXPECT_NEAR(ours[k], theirs[k], 1e-10 * (1.0 + std::fabs(theirs[k])));
    EXPECT_NEAR(waveSpeed<D>(m, F.data(), ours.data()), waveSpeed<D>(old, other.data(), theirs.data()),
                1e-10);
    EXPECT_NEAR(storedEnergy<D>(m, F.data(), ours.data()), storedEnergy<D>(old, other.data(), theirs.data()),
                1e-11);
    before = F;
  }
}

TEST(HighRateSolid, IsJ2PlasticWithoutRateAndHeat)
{
  expectJ2<2, Plane::Strain>();
  expectJ2<2, Plane::Stress>();
  expectJ2<3, Plane::Solid>();
}

/// A step without duration gives the stress of the last one again, and changes nothing.
TEST(HighRateSolid, GivesItsStressAgain)
{
  for (const bool shocked : {false, true})
  {
    Metal p = randomMetal(120u);
    p.shocked = shocked;
    p.linear = 0.3;
    p.quadratic = 1.5;
    Properties m = p.properties(Plane::Solid);
    m.cellSize = 1e-3;
    Outcome at = deform(m, 1e-5, 300);
    const LongHistory history = at.history;
    Matrix F = at.F;
    Symmetric<3> again{};
    updateStress<3>(LawStep{at.F.data(), 0.0, m.temperature}, m, F.data(), again.data(), at.history.data());
    for (int k = 0; k < 6; ++k)
      EXPECT_NEAR(again[k], at.tau[k], 1e-12 * p.K());
    for (int k = 0; k < HighRateSolid::historySize<3>; ++k)
      EXPECT_NEAR(at.history[k], history[k], 1e-12 * std::fabs(history[k]));
  }
}

/// Along the isentrope and after a shock the energy is that of the Hugoniot: with E = p_H eta / 2 the
/// pressure is p_H at every compression.
TEST(MieGrueneisen, HasTheHugoniotForItsReference)
{
  Metal p;
  p.shocked = true;
  const MieGrueneisen volume(p.properties(Plane::Solid));
  for (const double eta : {0.01, 0.05, 0.1, 0.2})
  {
    const double hugoniot = p.K() * eta / std::pow(1.0 - p.slope * eta, 2);
    double modulus = 0.0;
    EXPECT_NEAR(volume.pressure(1.0 - eta, 0.5 * hugoniot * eta, modulus) / hugoniot, 1.0, 1e-14);
    constexpr double h = 1e-5;
    const double rise = volume.cold(eta + h).pressure - volume.cold(eta - h).pressure;
    EXPECT_NEAR(volume.cold(eta).slope / (rise / (2.0 * h)), 1.0, 1e-7);
    // The modulus is the second derivative of the energy along the isentrope.
    double factor = 0.0;
    const double E = volume.compress(1e8, 0.0, eta, factor);
    const double up = volume.compress(E, eta, eta + h, factor),
                 down = volume.compress(E, eta, eta - h, factor);
    const double J = 1.0 - eta;
    volume.pressure(J, E, modulus);
    EXPECT_NEAR(modulus / (J * J * (up - 2.0 * E + down) / (h * h)), 1.0, 1e-4);
  }
  EXPECT_FALSE(volume.allows(1.0 - 1.0 / p.slope));
}

/// Large and fast strains, melting included, leave finite numbers.
TEST(HighRateSolid, StaysFinite)
{
  Random random;
  for (const bool shocked : {false, true})
  {
    Metal p;
    p.shocked = shocked;
    p.linear = 0.2;
    p.quadratic = 2.0;
    Properties m = p.properties(Plane::Solid);
    m.cellSize = 1e-3;
    LongHistory history{};
    Gradient<3> before = identity<3>();
    for (int s = 0; s < 1000; ++s)
    {
      Gradient<3> F = random.deformation<3>(shocked ? 0.85 : 0.4, 2.5);
      Symmetric<3> tau{};
      ASSERT_TRUE((updateStress<3>(LawStep{before.data(), std::pow(10.0, random.between(-9.0, 1.0)), 293.0},
                                   m, F.data(), tau.data(), history.data())));
      before = F;
      for (const double component : tau)
        ASSERT_TRUE(std::isfinite(component));
      ASSERT_TRUE(std::isfinite(waveSpeed<3>(m, F.data(), history.data())));
      ASSERT_TRUE(std::isfinite(storedEnergy<3>(m, F.data(), history.data())));
    }
    EXPECT_GT(p.temperature + history[8], p.melt); // it has melted
    Gradient<3> crushed = identity<3>();
    crushed[0] = shocked ? 0.3 : -0.1;
    Symmetric<3> tau{};
    EXPECT_FALSE(
        (updateStress<3>(LawStep{before.data(), 1.0, 293.0}, m, crushed.data(), tau.data(), history.data())));
  }
}

void expectRefused(const Metal& p, const std::string& text, Plane plane = Plane::Solid)
{
  try
  {
    p.properties(plane);
    FAIL() << text;
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
  }
}

TEST(HighRateSolid, RefusesImpossibleConstants)
{
  Metal p;
  p.A = -1.0;
  expectRefused(p, "Johnson-Cook A: is -1; give a positive");
  p = Metal();
  p.melt = 200.0;
  expectRefused(p, "give Melting Temperature > Transition Temperature = 293");
  p = Metal();
  p.capacity = 0.0;
  expectRefused(p, "Specific Heat: is missing");
  p = Metal();
  p.voce = 1e6;
  expectRefused(p, "Voce Rate: is missing");
  p = Metal();
  p.shocked = true;
  p.gamma = 3.0;
  expectRefused(p, "give Grueneisen Coefficient < 2 Hugoniot Slope = 2.978");
  p.gamma = 2.0;
  expectRefused(p, "not in plane stress", Plane::Stress);
  EXPECT_NE(refusesHeat(p.properties(Plane::Solid)), nullptr);
  p.shocked = false;
  EXPECT_EQ(refusesHeat(p.properties(Plane::Solid)), nullptr);
  EXPECT_EQ(firstYield(p.properties(Plane::Solid)), 90e6);
}

} // namespace

} // namespace Test
} // namespace Rhegma
