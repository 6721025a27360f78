/// Bodies that vibrate freely: energy over ten periods, and the period.
///
/// A bar of n cells with free ends in its first mode, u = cos(pi x / L), Poisson's ratio zero. On nodes with
/// lumped mass its frequency is w0 = (2 c / h) sin(kh/2), kh = pi / n. What particles give back to the nodes
/// is smoothed: with two particles a cell, at its quarter points, the projection of the particles' velocity
/// is S times the nodes' velocity, S = (5 + 3 cos kh) / 8. One step of the amplitudes (velocity v, strain u)
/// is
///
///     MUSL   v' = v - dt w0^2 u,   u' = u + dt S v'
///     USF    u' = u + dt S v,      v' = v - dt w0^2 u'
///     USL    v' = v - dt w0^2 u,   u' = u + dt (S v - dt w0^2 u)
///     USAVG  that of MUSL, of the strain s = (u + u') / 2 that a step ends with
///
/// The first two and the last have the determinant 1: the energy is kept, its fraction that swings within a
/// period aside, and sin(w dt / 2) = w0 sqrt(S) dt / 2. USL has the determinant 1 - (1 - S)(w0 dt)^2, which
/// is what a step leaves of the energy. Against the continuum, w = pi c / L, the period is longer by (kh)^2
/// (1/24 + 3/32) - (w dt)^2 / 24.

#include "Vibration.hpp"

#include <cmath>
#include <tuple>

namespace Rhegma
{
namespace Test
{

namespace
{

constexpr double kh = pi / barCells;
const double smoothing = (5.0 + 3.0 * std::cos(kh)) / 8.0;
const double lumped = 2.0 * std::sin(0.5 * kh);

template <int D>
void check(const std::string& scheme, const std::string& shape)
{
  const Vibration v = vibrate<D>(barScene<D>(scheme, shape), 1, 2.0 * barCells);
  const double ideal = 2.0 * barCells;
  const double discrete = pi * v.dt / std::asin(0.5 * lumped * std::sqrt(smoothing) * v.dt);
  const double longer = kh * kh * (1.0 / 24.0 + 3.0 / 32.0) - kh * kh * v.dt * v.dt / 24.0;
  std::printf(
      "%s, %s: energy kept over ten periods %.6f, swing %.4f, period %+.3f %% (dispersion %+.3f %%)\n",
      scheme.c_str(), shape.c_str(), v.kept, v.swing, 100.0 * (v.period / ideal - 1.0), 100.0 * longer);
  if (scheme == "USL")
  {
    // A period of 80 steps and a fraction is cut to whole steps.
    const double loss = -std::log1p(-(1.0 - smoothing) * std::pow(lumped * v.dt, 2)) * 10.0 * ideal / v.dt;
    // Boxes at the ends reach into cells beyond and give their nodes next to no mass: USL strains by what
    // such nodes do, and loses more.
    const double lost = -std::log(v.kept);
    EXPECT_NEAR(shape == "GIMP" ? std::min(lost, loss) : lost, loss, 0.02 * loss);
    return;
  }
  // Periods are cut to whole steps, of which there are 80: a mean is off by an eightieth of the swing.
  EXPECT_NEAR(v.kept, 1.0, scheme == "USAVG" ? 1e-5 : 1e-3);
  // Velocity and strain are half a step apart, so that the energy swings by sin(w t) cos(w t) w dt. With
  // USAVG they are of one time, and the mean of two strains is less by cos(w dt / 2) than those are.
  const double swing = scheme == "USAVG" ? 0.5 * std::pow(std::sin(0.5 * kh * v.dt), 2) : 0.5 * kh * v.dt;
  EXPECT_NEAR(v.swing, swing, 0.1 * swing);
  EXPECT_NEAR(v.period, discrete, 1e-4 * discrete);
  EXPECT_NEAR(v.period / ideal - 1.0, longer, 0.02 * longer);
}

class Bar : public testing::TestWithParam<std::tuple<std::string, std::string>>
{
};

} // namespace

TEST_P(Bar, KeepsEnergyAndPeriodIn2D) { check<2>(std::get<0>(GetParam()), std::get<1>(GetParam())); }

TEST_P(Bar, KeepsEnergyAndPeriodIn3D) { check<3>(std::get<0>(GetParam()), std::get<1>(GetParam())); }

INSTANTIATE_TEST_SUITE_P(FreeVibration, Bar,
                         testing::Combine(testing::Values("MUSL", "USF", "USL", "USAVG"),
                                          testing::Values("Linear", "GIMP")),
                         CaseName());

} // namespace Test
} // namespace Rhegma
