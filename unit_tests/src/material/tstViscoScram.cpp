/// The law ViscoSCRAM against integrated equations and closed forms.

#include "ViscoScramCase.hpp"

#include <algorithm>

namespace Rhegma
{
namespace Test
{

namespace
{

/// Strains along a path of the time 1. \return tau
template <class Path>
Symmetric<3> stressAfter(const Properties& m, double duration, int steps, LongHistory& history,
                         const Path& path)
{
  Symmetric<3> tau{};
  Matrix before = path(0.0);
  for (int s = 1; s <= steps; ++s)
  {
    Matrix F = path(static_cast<double>(s) / steps);
    EXPECT_TRUE((updateStress<3>(LawStep{before.data(), duration / steps, 300.0}, m, F.data(), tau.data(),
                                 history.data())));
    before = F;
  }
  return tau;
}

/// In tension and in compression.
Matrix pressedAt(double t) { return inverted(strainedAt(t)); }

/// Three rates: 1e-5 of the largest component, and of the damage. The steps of both have errors of 1e-7.
TEST(ViscoScram, FollowsTheIntegratedEquations)
{
  for (const bool pressed : {false, true})
    for (const double duration : {0.1, 1.0, 10.0})
    {
      const Scram p = randomScram(static_cast<unsigned>(100.0 * duration) + (pressed ? 1u : 0u), 5);
      const Properties m = p.properties(Plane::Solid);
      const auto path = [&](double t) { return pressed ? pressedAt(t) : strainedAt(t); };
      LongHistory history{};
      const Symmetric<3> tau = stressAfter(m, duration, 2000, history, path);
      // Relaxation and growth both have rates of at most some 100 over the path.
      const auto y = integrateScram(p, duration, 20000, path);
      const Matrix F = path(1.0);
      const double J = det(F);
      const ScramStress found = scramStress(p, F, y);
      const Matrix expected = sumOf(J, found.deviator, J * found.mean, one);
      double largest = 0.0;
      for (const double component : expected)
        largest = std::max(largest, std::fabs(component));
      for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j)
          EXPECT_NEAR(tau[symmetricIndex<3>(i, j)], expected[3 * i + j], 1e-5 * largest)
              << "in " << duration << " s";
      const double cube = std::pow(y[54] / p.scale, 3.0);
      EXPECT_NEAR(damageOf<3>(m, history.data()), cube / (1.0 + cube), 1e-5);
      EXPECT_GT(y[54], 1.03 * p.radius); // the test has growth to show
    }
}

/// The radius of a single step, with its own steps inside, against many: where growth begins, and past it.
TEST(ViscoScram, LongStepsFollowTheGrowth)
{
  for (const unsigned seed : {81u, 82u, 83u})
  {
    Scram p = randomScram(seed, 2);
    const Properties m = p.properties(Plane::Solid);
    const auto damage = [&](int steps)
    {
      LongHistory history{};
      stressAfter(m, 1.0, steps, history, strainedAt);
      return damageOf<3>(m, history.data());
    };
    const double fine = damage(4000);
    EXPECT_GT(fine, 2.0 * damageOf<3>(m, LongHistory{}.data()));
    EXPECT_NEAR(damage(20), fine, 0.02);
    // Second order in the step.
    EXPECT_LT(std::fabs(damage(100) - fine), 0.5 * std::fabs(damage(50) - fine) + 1e-5);
  }
}

/// Without growth, and with cracks too small to be felt, a held shear relaxes as the generalised Maxwell
/// solid: mu (1 - sum g (1 - exp(-t / time))) gamma.
TEST(ViscoScram, RelaxesAsTheSeriesWithoutCracks)
{
  constexpr double gamma = 1e-5;
  Scram p = randomScram(11u, 5);
  p.radius = 1e-4 * p.scale; // its compliance is 1e-12 of that of shear
  p.toughness = 1e6;
  const Properties m = p.properties(Plane::Solid);
  Matrix F = one, before = one;
  LongHistory history{};
  Symmetric<3> tau{};
  F[1] = gamma;
  updateStress<3>(LawStep{before.data(), 1e-9, 300.0}, m, F.data(), tau.data(), history.data());
  double t = 0.0;
  for (double dt = 1e-3; t < 100.0; dt *= 1.05)
  {
    updateStress<3>(LawStep{F.data(), dt, 300.0}, m, F.data(), tau.data(), history.data());
    t += dt;
    double modulus = p.G();
    for (std::size_t i = 0; i < p.prony.times.size(); ++i)
      modulus -= p.prony.shear[i] * p.G() * -std::expm1(-t / p.prony.times[i]);
    EXPECT_NEAR(tau[3] / (modulus * gamma), 1.0, 1e-6);
  }
}

/// Cracks that do not grow add (c/a)^3 times the compliance at once.
TEST(ViscoScram, CracksAreCompliant)
{
  Scram p = randomScram(12u, 3);
  p.radius = 0.8 * p.scale;
  p.toughness = 1e6;
  const Properties m = p.properties(Plane::Solid);
  Matrix F = one, before = one;
  F[1] = 1e-5;
  LongHistory history{};
  Symmetric<3> tau{};
  updateStress<3>(LawStep{before.data(), 1e-12, 300.0}, m, F.data(), tau.data(), history.data());
  EXPECT_NEAR(tau[3] * (1.0 + std::pow(0.8, 3.0)) / (p.G() * F[1]), 1.0, 1e-7);
}

/// The trapezoidal work of the stress is stored or dissipated; the error is of second order in the step.
TEST(ViscoScram, StoresOrDissipatesItsWork)
{
  for (const unsigned seed : {1u, 2u, 3u})
  {
    const Properties m = randomScram(seed, 5).properties(Plane::Solid);
    const auto error = [&](int count)
    {
      LongHistory history{};
      Matrix before = one;
      Symmetric<3> tau{}, old{};
      double work = 0.0, lost = 0.0;
      for (int s = 1; s <= count; ++s)
      {
        Matrix F = strainedAt(static_cast<double>(s) / count);
        updateStress<3>(LawStep{before.data(), 1.0 / count, 300.0}, m, F.data(), tau.data(), history.data());
        const Matrix middle = sumOf(0.5, F, 0.5, before);
        const Matrix L = times(sumOf(1.0, F, -1.0, before), inverted(middle));
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            work += 0.5 * (tau[symmetricIndex<3>(i, j)] + old[symmetricIndex<3>(i, j)]) * L[3 * i + j];
        const double now = dissipatedEnergy<3>(m, history.data());
        EXPECT_GE(now, lost); // second law
        lost = now;
        old = tau;
        before = F;
      }
      EXPECT_GT(lost, 0.01 * work);
      return std::fabs((storedEnergy<3>(m, before.data(), history.data()) + lost) / work - 1.0);
    };
    EXPECT_LT(error(800), 1e-4);
    EXPECT_LT(error(800), 0.3 * error(400));
  }
}

/// Plane stress is the solid without stress across the plane, growth of cracks included: what the passes over
/// thickness and radius leave is of third order in the step.
TEST(ViscoScram, PlaneStressIsTheSolidWithoutStressAcross)
{
  const Scram p = randomScram(31u, 3);
  const Properties plane = p.properties(Plane::Stress), body = p.properties(Plane::Solid);
  LongHistory flat{}, thick{};
  Gradient<2> before = identity<2>();
  Symmetric<2> tau{};
  Symmetric<3> full{};
  for (int s = 1; s <= 400; ++s)
  {
    const double t = s / 400.0;
    Gradient<2> F = {1.0 + 0.3 * t, 0.2 * std::sin(3.0 * t), -0.1 * t, 1.0 - 0.1 * t, before[4]};
    ASSERT_TRUE(
        (updateStress<2>(LawStep{before.data(), 2.5e-3, 300.0}, plane, F.data(), tau.data(), flat.data())));
    Gradient<3> whole = solid(F);
    const Gradient<3> wholeBefore = solid(before);
    updateStress<3>(LawStep{wholeBefore.data(), 2.5e-3, 300.0}, body, whole.data(), full.data(),
                    thick.data());
    before = F;
    const Symmetric<3> expected = solid(tau);
    for (int k = 0; k < 6; ++k)
      EXPECT_NEAR(full[k], expected[k], 1e-7);
  }
  const double damage = damageOf<2>(plane, flat.data());
  EXPECT_GT(damage, 2.0 * damageOf<2>(plane, LongHistory{}.data()));
  EXPECT_NEAR(damage, damageOf<3>(body, thick.data()), 1e-7);
  EXPECT_NEAR(dissipatedEnergy<2>(plane, flat.data()) / dissipatedEnergy<3>(body, thick.data()), 1.0, 1e-6);
}

/// rho c^2 is at least the second derivative of the energy along every plane wave that leaves no time for
/// relaxation or growth, from strained states with cracks; at rest it is the dilatational wave.
template <int D, Plane P>
void expectBoundOfWaves(unsigned seed)
{
  Random random;
  const Scram p = randomScram(seed, 3);
  const Properties m = p.properties(P);
  LongHistory history{};
  Gradient<D> F = identity<D>();
  EXPECT_NEAR(waveSpeed<D>(m, F.data(), history.data()), std::sqrt((m.planeLambda + 2.0 * m.mu) / 2.0),
              1e-12);
  for (int trial = 0; trial < 200; ++trial)
  {
    F = identity<D>();
    history = {};
    Symmetric<D> tau{};
    Gradient<D> start = F;
    for (int s = 0; s < 3; ++s)
    {
      const double thickness = F[4];
      F = random.deformation<D>(0.75, 1.3);
      if (P == Plane::Stress)
        F[4] = thickness;
      ASSERT_TRUE(
          (updateStress<D>(LawStep{start.data(), 0.1, 300.0}, m, F.data(), tau.data(), history.data())));
      start = F;
    }
    const double bound = 2.0 * std::pow(waveSpeed<D>(m, F.data(), history.data()), 2);
    for (int wave = 0; wave < 30; ++wave)
    {
      const auto n = random.direction<D>(), direction = random.direction<D>();
      constexpr double size = 1e-3;
      const auto energy = [&](double e)
      {
        Gradient<D> at = multiply<D>(dyad<D>(e, direction, n), F);
        LongHistory memory = history;
        Symmetric<D> unused{};
        updateStress<D>(LawStep{F.data(), 1e-12, 300.0}, m, at.data(), unused.data(), memory.data());
        return storedEnergy<D>(m, at.data(), memory.data());
      };
      const double second = (energy(size) - 2.0 * energy(0.0) + energy(-size)) / (size * size);
      EXPECT_LE(second, bound * (1.0 + 1e-4));
    }
  }
}

TEST(ViscoScram, WaveSpeedIsABound)
{
  expectBoundOfWaves<2, Plane::Strain>(41u);
  expectBoundOfWaves<2, Plane::Stress>(42u);
  expectBoundOfWaves<3, Plane::Solid>(43u);
}

/// A rotation of the body, other in each step, rotates the stress and nothing else.
TEST(ViscoScram, IsObjective)
{
  Random random;
  const Properties m = randomScram(51u, 4).properties(Plane::Solid);
  for (int trial = 0; trial < 50; ++trial)
  {
    LongHistory a{}, b{};
    Gradient<3> before = identity<3>(), turnedBefore = before;
    for (int s = 0; s < 3; ++s)
    {
      const Gradient<3> F = random.deformation<3>(0.8, 1.25), Q = random.rotation<3>();
      Gradient<3> at = F, turned = multiply<3>(Q, F);
      Symmetric<3> tau{}, rotated{};
      updateStress<3>(LawStep{before.data(), 0.1, 300.0}, m, at.data(), tau.data(), a.data());
      updateStress<3>(LawStep{turnedBefore.data(), 0.1, 300.0}, m, turned.data(), rotated.data(), b.data());
      const Symmetric<3> expected = rotate<3>(Q, tau);
      for (int k = 0; k < 6; ++k)
        EXPECT_NEAR(rotated[k], expected[k], 1e-11);
      before = F;
      turnedBefore = turned;
    }
    EXPECT_NEAR(damageOf<3>(m, a.data()), damageOf<3>(m, b.data()), 1e-11);
  }
}

/// Large strains and long steps leave finite numbers, dissipation and damage that never fall, and damage
/// below 1.
TEST(ViscoScram, StaysFiniteAtLargeStrain)
{
  Random random;
  const Properties m = randomScram(61u, 5).properties(Plane::Solid);
  LongHistory history{};
  Gradient<3> before = identity<3>();
  double lost = 0.0, damage = 0.0;
  for (int s = 0; s < 500; ++s)
  {
    Gradient<3> F = random.deformation<3>(0.1, 8.0);
    Symmetric<3> tau{};
    ASSERT_TRUE((updateStress<3>(LawStep{before.data(), std::pow(10.0, random.between(-9.0, 9.0)), 300.0}, m,
                                 F.data(), tau.data(), history.data())));
    before = F;
    for (const double component : tau)
      ASSERT_TRUE(std::isfinite(component));
    ASSERT_TRUE(std::isfinite(waveSpeed<3>(m, F.data(), history.data())));
    const double now = dissipatedEnergy<3>(m, history.data()), broken = damageOf<3>(m, history.data());
    ASSERT_GE(now, lost * (1.0 - 1e-12));
    ASSERT_GE(broken, damage);
    ASSERT_LE(broken, 1.0);
    lost = now;
    damage = broken;
  }
  EXPECT_GT(damage, 0.5);
  Gradient<3> inside = identity<3>();
  inside[0] = -1.0;
  Symmetric<3> tau{};
  EXPECT_FALSE(
      (updateStress<3>(LawStep{before.data(), 1.0, 300.0}, m, inside.data(), tau.data(), history.data())));
}

/// The radius of a merged particle is the mean by volume, and the largest speed of waves counts.
TEST(ViscoScram, MergesByVolume)
{
  const Properties m = randomScram(62u, 2).properties(Plane::Solid);
  const double parts[2] = {0.0, 0.04}, volume[2] = {0.25, 0.75}, mass[2] = {0.5, 0.5};
  const int radius = ViscoScram::growthIndex<3>, speed = ViscoScram::speedIndex<3>;
  EXPECT_DOUBLE_EQ(merged(meanOfHistory<3>(m, radius), parts, volume, mass), 0.03);
  EXPECT_DOUBLE_EQ(merged(meanOfHistory<3>(m, speed), parts, volume, mass), 0.04);
}

TEST(ViscoScram, OnlyLawsWithDamageHaveOne)
{
  EXPECT_TRUE(damages(randomScram(63u, 1).properties(Plane::Solid)));
  const Properties elastic = hookean("Linear Elastic", Plane::Solid, 2.6, 0.3);
  EXPECT_FALSE(damages(elastic));
  EXPECT_EQ(damageOf<3>(elastic, nullptr), 0.0);
  EXPECT_EQ(lawsWithDamage(), std::vector<std::string>{"ViscoSCRAM"});
}

void expectRefusedConstants(const Scram& p, const std::string& text)
{
  try
  {
    p.properties(Plane::Solid);
    FAIL() << text;
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
  }
}

TEST(ViscoScram, RefusesImpossibleConstants)
{
  const Scram good = randomScram(71u, 2);
  Scram p = good;
  p.radius = p.scale = 0.1;
  expectRefusedConstants(p, "Initial Crack Radius: is 0.1 m; it must be < Crack Length Scale = 0.1 m");
  p = good;
  p.radius = 0.0;
  expectRefusedConstants(p, "Initial Crack Radius: is 0; give a positive");
  p = good;
  p.toughness *= 1e-3;
  expectRefusedConstants(p, "must be >= 0.001 J/m2, the surface energy of any solid");
  p = good;
  p.friction = 1.3;
  expectRefusedConstants(p, "Crack Friction: is 1.3; 2 mu^2 < 3 must hold");
  p = good;
  p.speed = 0.95 * std::sqrt(p.G() / 2.0);
  expectRefusedConstants(p, "m/s, the speed of Rayleigh waves");
  p = good;
  p.prony.shear = {0.7, 0.6};
  expectRefusedConstants(p, "has the sum 1.3; the sum of the fractions must be <= 1");
}

} // namespace

} // namespace Test
} // namespace Rhegma
