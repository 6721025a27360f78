/// The law of StandardLinearSolid.hpp in the kernel of a step, against closed forms.

#include "StandardLinearSolid.hpp"

#include "material/MaterialReader.hpp"
#include "scene/Schema.hpp"
#include "transfer/LaneStress.hpp"

#include <gtest/gtest.h>

#include <limits>

using namespace Rhegma;

namespace
{

/// The list of src/material/Laws.hpp with one entry more; to have the law in scenes, write it there.
using WithMine = LawList<LinearElastic, NeoHookean, MooneyRivlin, J2Plastic, Viscoelastic, HighRateSolid,
                         StandardLinearSolid>;

constexpr double young = 3.0e9, poisson = 0.35, viscousShear = 2.0e9, relaxationTime = 1.0e-3;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

Properties material(Plane plane)
{
  Teuchos::ParameterList list;
  list.set("Model", "Standard Linear Solid");
  list.set("Density", 1200.0);
  list.set("Young Modulus", young);
  list.set("Poisson Ratio", poisson);
  list.set("Viscous Shear Modulus", viscousShear);
  list.set("Relaxation Time", relaxationTime);
  list.set("Activation Temperature", 5000.0);
  return readMaterial<WithMine>(list, "Resin", plane);
}

/// A particle that the kernel of a step strains.
template <int D>
struct Particle
{
  Properties law;
  detail::StrainLanes<D> at{};
  double history[symmetricSize<D> + 1] = {};

  explicit Particle(Plane plane) : law(material(plane))
  {
    for (int d = 0; d < D; ++d)
      at.F[d * D + d][0] = 1.0;
    if (D == 2)
      at.F[4][0] = 1.0;
  }

  /// Shears at a rate [1/s] for a time [s].
  void step(double rate, double dt)
  {
    at.gradient[1][0] = rate;
    at.speed[0] = 0.0;
    withLaw<D, WithMine>(law.law, law.plane,
                         detail::StressOfLanes<D>{law, at, history, symmetricSize<D> + 1, dt, 0, 1});
    EXPECT_TRUE(std::isfinite(at.speed[0]));
  }

  /// S_xy = tau_xy - gamma tau_yy in simple shear.
  double shearStress() const
  {
    return at.tau[symmetricIndex<D>(0, 1)][0] - at.F[1][0] * at.tau[symmetricIndex<D>(1, 1)][0];
  }
};

/// Sheared at once and held: S_xy = (mu + viscousShear exp(-t / time)) gamma.
template <int D>
void expectRelaxation(Plane plane)
{
  constexpr double gamma = 1.0e-2, dt = 1.0e-5;
  constexpr int steps = 300; // three relaxation times
  Particle<D> particle(plane);
  particle.step(gamma / 1.0e-12, 1.0e-12); // at once: 1e-9 of the relaxation time
  const double start = particle.history[symmetricIndex<D>(0, 1)];
  EXPECT_NEAR(start, viscousShear * gamma, 1.0e-9 * viscousShear * gamma);
  for (int n = 1; n <= steps; ++n)
  {
    particle.step(0.0, dt);
    const double expected = particle.law.mu * gamma + start * std::exp(-n * dt / relaxationTime);
    // Each step rounds the decay factor and the product; the stress is a sum of some ten terms.
    EXPECT_NEAR(particle.shearStress(), expected, (3.0 * n + 20.0) * epsilon * start);
  }
}

TEST(StandardLinearSolid, Relaxes)
{
  expectRelaxation<2>(Plane::Strain);
  expectRelaxation<2>(Plane::Stress);
  expectRelaxation<3>(Plane::Solid);
}

/// Sheared at a constant rate: Q_xy = viscousShear rate time (1 - exp(-t / time)), with steps of any length,
/// since the update is exact for a constant rate of strain.
TEST(StandardLinearSolid, IsExactAtAConstantRate)
{
  constexpr double rate = 10.0;
  for (const double dt : {1.0e-5, 1.0e-3})
  {
    Particle<3> particle(Plane::Solid);
    const int steps = static_cast<int>(std::lround(2.0e-3 / dt));
    for (int n = 0; n < steps; ++n)
      particle.step(rate, dt);
    const double expected = viscousShear * rate * relaxationTime * -std::expm1(-steps * dt / relaxationTime);
    EXPECT_NEAR(particle.history[symmetricIndex<3>(0, 1)] / expected, 1.0, (6.0 * steps + 20.0) * epsilon);
  }
}

/// What the branch loses while nothing strains it is dissipated.
TEST(StandardLinearSolid, DissipatesWhatItLoses)
{
  Particle<3> particle(Plane::Solid);
  particle.step(1.0e10, 1.0e-12);
  const auto stored = [&]
  {
    double F[9];
    for (int k = 0; k < 9; ++k)
      F[k] = particle.at.F[k][0];
    return StandardLinearSolid::energy<3, Plane::Solid>(particle.law, F, particle.history);
  };
  const double dissipated = particle.history[StandardLinearSolid::dissipationIndex<3>], whole = stored();
  for (int n = 0; n < 100; ++n)
    particle.step(0.0, 1.0e-4);
  const double lost = whole - stored();
  EXPECT_GT(lost, 0.1 * whole);
  EXPECT_NEAR(particle.history[StandardLinearSolid::dissipationIndex<3>] - dissipated, lost,
              500.0 * epsilon * whole);
}

TEST(StandardLinearSolid, RelaxesFasterWhereItIsWarmer)
{
  const Properties m = material(Plane::Solid);
  double F[9] = {1.0, 0.01, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}, tau[6];
  const auto after = [&](double temperature)
  {
    double history[7] = {};
    history[symmetricIndex<3>(0, 1)] = 1.0;
    updateStress<3, WithMine>({F, 1.0e-4, temperature}, m, F, tau, history);
    return std::log(history[symmetricIndex<3>(0, 1)]);
  };
  EXPECT_NEAR(after(330.0) / after(m.temperature), std::exp(5000.0 * (1.0 / m.temperature - 1.0 / 330.0)),
              1.0e-12);
}

TEST(StandardLinearSolid, SpeedOfWavesIsThatBeforeRelaxation)
{
  const Properties m = material(Plane::Solid);
  const double F[9] = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}, history[7] = {};
  EXPECT_DOUBLE_EQ((StandardLinearSolid::waveSpeed<3, Plane::Solid>(m, F, history)),
                   std::sqrt((m.bulk + 4.0 / 3.0 * (m.mu + viscousShear)) / 1200.0));
}

TEST(StandardLinearSolid, DescribesItsParameters)
{
  Section section(StandardLinearSolid::name, StandardLinearSolid::meaning);
  StandardLinearSolid::describe(section);
  ASSERT_NE(section.findParameter("Relaxation Time"), nullptr);
  EXPECT_EQ(section.findParameter("Relaxation Time")->unit, "s");
}

} // namespace
