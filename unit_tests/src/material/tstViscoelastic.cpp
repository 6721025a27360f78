/// The law Viscoelastic against integrated equations and closed forms.

#include "ViscoelasticCase.hpp"

#include <algorithm>

namespace Rhegma
{
namespace Test
{

namespace
{

constexpr int steps = 2000;

/// Strains along strainedAt(t / duration). \return tau
Symmetric<3> stressAfter(const Properties& m, double duration, LongHistory& history, double temperature)
{
  Symmetric<3> tau{};
  Matrix before = strainedAt(0.0);
  for (int s = 1; s <= steps; ++s)
  {
    Matrix F = strainedAt(static_cast<double>(s) / steps);
    EXPECT_TRUE((updateStress<3>(LawStep{before.data(), duration / steps, temperature}, m, F.data(),
                                 tau.data(), history.data())));
    before = F;
  }
  return tau;
}

/// The equations of Viscoelastic.hpp, integrated as they stand: y holds e_i of five elements and v_i.
Matrix referenceStress(const Prony& p, double duration, double inverseShift)
{
  constexpr double small = 1e-5;
  const auto isochoric = [](double t)
  {
    const Matrix F = strainedAt(t), C = times(transposed(F), F);
    return sumOf(0.5 * std::pow(det(F), -2.0 / 3.0), C, -0.5, one);
  };
  const auto rate = [&](double t, const std::array<double, 50>& y)
  {
    std::array<double, 50> r{};
    const Matrix dE = sumOf(0.5 / small, isochoric(t + small), -0.5 / small, isochoric(t - small));
    const double dv =
        (std::log(det(strainedAt(t + small))) - std::log(det(strainedAt(t - small)))) / (2.0 * small);
    for (std::size_t i = 0; i < p.times.size(); ++i)
    {
      const double relax = duration * inverseShift / p.times[i];
      for (std::size_t k = 0; k < 9; ++k)
        r[9 * i + k] = dE[k] - relax * y[9 * i + k];
      r[45 + i] = dv - relax * y[45 + i];
    }
    return r;
  };
  double fastest = 0.0;
  for (const double time : p.times)
    fastest = std::max(fastest, duration * inverseShift / time);
  const auto y = integrate(rate, std::array<double, 50>{}, 1.0, 2000 + static_cast<int>(fastest));

  double longShear = p.mu(), longBulk = p.K(), pressure = 0.0;
  Matrix S{};
  for (std::size_t i = 0; i < p.times.size(); ++i)
  {
    longShear -= p.shear[i] * p.mu();
    longBulk -= p.bulk[i] * p.K();
    for (std::size_t k = 0; k < 9; ++k)
      S[k] += 2.0 * p.shear[i] * p.mu() * y[9 * i + k];
    pressure += p.bulk[i] * p.K() * y[45 + i];
  }
  const Matrix F = strainedAt(1.0);
  const double J = det(F);
  S = sumOf(1.0, S, longShear, one);
  const Matrix pushed = times(F, times(S, transposed(F)));
  return sumOf(std::pow(J, -2.0 / 3.0), deviator(pushed), 0.5 * longBulk * (J * J - 1.0) + pressure, one);
}

/// Three rates, at three temperatures each, with both shifts: 0.1 % of the largest component.
TEST(Viscoelastic, FollowsTheIntegratedEquations)
{
  for (const char* shift : {"None", "Williams-Landel-Ferry", "Arrhenius"})
    for (const double temperature : {285.0, 300.0, 330.0})
      for (const double duration : {0.01, 1.0, 100.0})
      {
        Prony p = randomProny(static_cast<unsigned>(1000.0 * duration + temperature), 5);
        p.shift = shift;
        p.temperature = temperature;
        double faster = 1.0;
        if (p.shift == "Arrhenius")
          faster = std::exp(-p.activation * (1.0 / temperature - 1.0 / p.shiftTemperature));
        else if (p.shift != "None")
          faster = std::pow(10.0, p.c1 * (temperature - p.shiftTemperature) /
                                      (p.c2 + temperature - p.shiftTemperature));
        LongHistory history{};
        const Symmetric<3> tau = stressAfter(p.properties(Plane::Solid), duration, history, temperature);
        const Matrix expected = referenceStress(p, duration, faster);
        double largest = 0.0;
        for (const double component : expected)
          largest = std::max(largest, std::fabs(component));
        for (int i = 0; i < 3; ++i)
          for (int j = i; j < 3; ++j)
            EXPECT_NEAR(tau[symmetricIndex<3>(i, j)], expected[3 * i + j], 1e-3 * largest)
                << shift << " at " << temperature << " K in " << duration << " s";
      }
}

/// The trapezoidal work of the stress is stored or dissipated; the error is of second order in the step.
TEST(Viscoelastic, StoresOrDissipatesItsWork)
{
  for (const unsigned seed : {1u, 2u, 3u})
  {
    const Properties m = randomProny(seed, 5).properties(Plane::Solid);
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
    EXPECT_LT(error(400), 1e-4);
    EXPECT_LT(error(400), 0.3 * error(200));
  }
}

/// The stress of a small shear that is held at once: mu (1 - sum g (1 - exp(-t / time))) gamma.
TEST(Viscoelastic, RelaxesAsTheSeries)
{
  constexpr double gamma = 1e-5;
  for (const int terms : {1, 5})
  {
    const Prony p = randomProny(10u + static_cast<unsigned>(terms), terms);
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
      double modulus = p.mu();
      for (int i = 0; i < terms; ++i)
        modulus -= p.shear[i] * p.mu() * -std::expm1(-t / p.times[i]);
      EXPECT_NEAR(tau[3] / (modulus * gamma), 1.0, 1e-6);
    }
  }
}

/// Creep under a shear stress: compliance by the roots of s G(s), which lie between the relaxation rates.
double compliance(const Prony& p, double t)
{
  const auto modulus = [&](double s, double& slope)
  {
    double G = p.mu();
    slope = 0.0;
    for (std::size_t i = 0; i < p.times.size(); ++i)
    {
      const double g = p.shear[i] * p.mu(), x = 1.0 + s * p.times[i];
      G -= g / x;
      slope += g * p.times[i] / (x * x);
    }
    return G;
  };
  std::vector<double> rates;
  double longShear = p.mu();
  for (std::size_t i = 0; i < p.times.size(); ++i)
  {
    rates.push_back(1.0 / p.times[i]);
    longShear -= p.shear[i] * p.mu();
  }
  std::sort(rates.begin(), rates.end());
  double J = 1.0 / longShear, slope = 0.0;
  for (std::size_t i = 0; i < rates.size(); ++i)
  {
    double low = i > 0 ? rates[i - 1] : 0.0, high = rates[i]; // the modulus falls with -s
    for (int k = 0; k < 200; ++k)
    {
      const double middle = 0.5 * (low + high);
      (modulus(-middle, slope) > 0.0 ? low : high) = middle;
    }
    const double s = -0.5 * (low + high);
    modulus(s, slope);
    J += std::exp(s * t) / (s * slope);
  }
  return J;
}

TEST(Viscoelastic, CreepsAsTheRootsOfItsModulus)
{
  for (const int terms : {1, 5})
  {
    const Prony p = randomProny(20u + static_cast<unsigned>(terms), terms);
    const Properties m = p.properties(Plane::Solid);
    constexpr double stress = 1e-5, dt = 1e-3;
    Matrix F = one, before = one;
    LongHistory history{};
    const auto shear = [&](double gamma, double step, LongHistory& memory)
    {
      Symmetric<3> tau{};
      F[1] = gamma;
      updateStress<3>(LawStep{before.data(), step, 300.0}, m, F.data(), tau.data(), memory.data());
      return tau[3];
    };
    for (int s = 0; s <= 3000; ++s)
    {
      // The stress is linear in the shear: two evaluations give the shear that bears the load.
      const double step = s == 0 ? 1e-9 : dt, probe = before[1] + 1e-5;
      LongHistory a = history, b = history;
      const double low = shear(before[1], step, a), high = shear(probe, step, b);
      const double gamma = before[1] + (stress - low) / (high - low) * (probe - before[1]);
      shear(gamma, step, history);
      before = F;
      if (s % 500 == 0)
      {
        EXPECT_NEAR(gamma / (stress * compliance(p, s * dt)), 1.0, 1e-3) << s * dt;
      }
    }
  }
}

/// Of a strain without time for relaxation the law is that of the moduli at once, and plane stress is the
/// solid without stress across the plane.
TEST(Viscoelastic, PlaneStressIsTheSolidWithoutStressAcross)
{
  const Prony p = randomProny(31u, 3);
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
      EXPECT_NEAR(full[k], expected[k], 1e-9);
  }
  EXPECT_NEAR(dissipatedEnergy<2>(plane, flat.data()) / dissipatedEnergy<3>(body, thick.data()), 1.0, 1e-9);
}

/// rho c^2 is at least the second derivative of the energy along every plane wave that leaves no time for
/// relaxation, from states with strained elements; at rest it is the dilatational wave.
template <int D, Plane P>
void expectBound(unsigned seed)
{
  Random random;
  const Prony p = randomProny(seed, 3);
  const Properties m = p.properties(P);
  LongHistory history{};
  Gradient<D> F = identity<D>();
  EXPECT_NEAR(waveSpeed<D>(m, F.data(), history.data()), std::sqrt((m.planeLambda + 2.0 * m.mu) / 2.0),
              1e-12);
  for (int trial = 0; trial < 200; ++trial)
  {
    const Gradient<D> before = F = identity<D>();
    history = {};
    Symmetric<D> tau{};
    Gradient<D> start = before;
    for (int s = 0; s < 3; ++s)
    {
      const double thickness = F[4];
      F = random.deformation<D>(0.75, 1.3);
      if (P == Plane::Stress)
        F[4] = thickness;
      ASSERT_TRUE(
          (updateStress<D>(LawStep{start.data(), 0.3, 300.0}, m, F.data(), tau.data(), history.data())));
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

TEST(Viscoelastic, WaveSpeedIsABound)
{
  expectBound<2, Plane::Strain>(41u);
  expectBound<2, Plane::Stress>(42u);
  expectBound<3, Plane::Solid>(43u);
}

/// A rotation of the body rotates the stress and nothing else.
TEST(Viscoelastic, IsObjective)
{
  Random random;
  const Properties m = randomProny(51u, 4).properties(Plane::Solid);
  for (int trial = 0; trial < 50; ++trial)
  {
    const Gradient<3> F = random.deformation<3>(0.7, 1.4), Q = random.rotation<3>(), before = identity<3>();
    Gradient<3> at = F, turned = multiply<3>(Q, F);
    LongHistory a{}, b{};
    Symmetric<3> tau{}, rotated{};
    updateStress<3>(LawStep{before.data(), 0.5, 300.0}, m, at.data(), tau.data(), a.data());
    updateStress<3>(LawStep{before.data(), 0.5, 300.0}, m, turned.data(), rotated.data(), b.data());
    const Symmetric<3> expected = rotate<3>(Q, tau);
    for (int k = 0; k < 6; ++k)
      EXPECT_NEAR(rotated[k], expected[k], 1e-12);
  }
}

/// Large strains and long steps leave finite numbers, and an energy that does not exceed the work.
TEST(Viscoelastic, StaysFiniteAtLargeStrain)
{
  Random random;
  const Properties m = randomProny(61u, 5).properties(Plane::Solid);
  LongHistory history{};
  Gradient<3> before = identity<3>();
  double lost = 0.0;
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
    const double now = dissipatedEnergy<3>(m, history.data());
    ASSERT_GE(now, lost * (1.0 - 1e-12));
    lost = now;
  }
  Gradient<3> inside = identity<3>();
  inside[0] = -1.0;
  Symmetric<3> tau{};
  EXPECT_FALSE(
      (updateStress<3>(LawStep{before.data(), 1.0, 300.0}, m, inside.data(), tau.data(), history.data())));
}

/// Both forms of the factors of a Maxwell step agree where one takes over from the other.
TEST(MaxwellStep, IsContinuous)
{
  const MaxwellStep series = maxwellStep(0.1), closed = maxwellStep(0.1 * (1.0 + 1e-15));
  EXPECT_NEAR(series.loss / closed.loss, 1.0, 1e-14);
  EXPECT_NEAR(series.gain / closed.gain, 1.0, 1e-14);
  EXPECT_NEAR(series.delay / closed.delay, 1.0, 1e-13);
  EXPECT_EQ(maxwellStep(0.0).gain, 1.0);
  EXPECT_EQ(maxwellStep(0.0).delay, 0.5);
}

void expectRefused(const Prony& p, const std::string& text)
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

TEST(Viscoelastic, RefusesImpossibleConstants)
{
  const Prony good = randomProny(71u, 2);
  Prony p = good;
  p.shear = {0.5, -0.1};
  expectRefused(p, "every fraction must be >= 0");
  p.shear = {0.7, 0.6};
  expectRefused(p, "has the sum 1.3; the sum of the fractions must be <= 1");
  p = good;
  p.bulk = {0.5, 0.5};
  expectRefused(p, "must be < 1");
  p = good;
  p.times = {0.1, 0.0};
  expectRefused(p, "every time must be > 0 s");
  p.times = {0.1};
  expectRefused(p, "Shear Fractions: has 2 numbers, but Relaxation Times has 1");
  p.times = {1, 1, 1, 1, 1, 1};
  expectRefused(p, "give 1 to 5 relaxation times");
  p = good;
  p.shift = "Williams-Landel-Ferry";
  p.temperature = 100.0;
  expectRefused(p, "Shift Temperature - WLF C2 = 180 K only");
}

} // namespace

} // namespace Test
} // namespace Rhegma
