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
///
/// The first two have the determinant 1: the energy is kept, its share that swings within a period aside, and
/// sin(w dt / 2) = w0 sqrt(S) dt / 2. The third has the determinant 1 - (1 - S)(w0 dt)^2, which is what a
/// step leaves of the energy. Against the continuum, w = pi c / L, the period is longer by (kh)^2 (1/24 +
/// 3/32) - (w dt)^2 / 24.

#include "Bodies.hpp"

#include <cmath>
#include <tuple>

namespace Rhegma
{
namespace Test
{

namespace
{

constexpr double pi = 3.14159265358979323846;
constexpr int cells = 16;
constexpr double length = cells; // cells of 1 m, waves of 1 m/s
constexpr double amplitude = 1e-5;

struct Vibration
{
  double kept = 0.0;   ///< mean energy of the eleventh period over that of the first
  double swing = 0.0;  ///< largest difference of the energy from its mean in the first period, over it
  double period = 0.0; ///< mean of ten [s]
  double dt = 0.0;
};

/// The modal shape between nodes as the nodes see it.
double shapeAt(double x)
{
  const double k = pi / length;
  const double node = std::floor(x), s = x - node;
  return (1.0 - s) * std::cos(k * node) + s * std::cos(k * (node + 1.0));
}

template <int D>
Vibration vibrate(const std::string& scheme, const std::string& shape)
{
  Vector<D> lower = all<D>(-2.0), upper = all<D>(4.0), end = all<D>(2.0);
  upper[0] = length + 2.0;
  end[0] = length;
  Teuchos::ParameterList scene = emptyScene<D>(lower, upper, 1.0, scheme, shape);
  addMaterial(scene, "Linear Elastic", 0.0);
  addBox<D>(scene, "Bar", all<D>(0.0), end);
  Rhegma::Run<D> run(validated(scene));
  run.initialize();
  State<D>& state = run.state();
  std::vector<double> mode(state.particles.size());
  {
    const HostParticles<D> particles(state);
    const auto id =
        Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.particles.integer(fields::id));
    for (int p = 0; p < particles.size; ++p)
    {
      mode[id(p)] = shapeAt(particles.position(p, 0));
      particles.velocity(p, 0) = amplitude * mode[id(p)];
    }
    particles.store(state);
  }

  Vibration result;
  const double period = 2.0 * length;
  std::vector<double> crossings;
  double energy[11] = {}, weight[11] = {}, largest = 0.0, smallest = 1e300;
  double before = amplitude, timeBefore = 0.0;
  while (state.time < 11.0 * period)
  {
    run.step(1e30, false);
    result.dt = state.dt;
    measureEnergy(state);
    const double now = state.energy.kinetic + state.energy.strain;
    const int n = std::min(10, static_cast<int>(state.time / period));
    energy[n] += state.dt * now;
    weight[n] += state.dt;
    if (n == 0)
    {
      largest = std::max(largest, now);
      smallest = std::min(smallest, now);
    }
    const HostParticles<D> particles(state);
    const auto id =
        Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.particles.integer(fields::id));
    double modal = 0.0;
    for (int p = 0; p < particles.size; ++p)
      modal += particles.mass(p) * mode[id(p)] * particles.velocity(p, 0);
    if (modal * before < 0.0)
      crossings.push_back(timeBefore + (state.time - timeBefore) * before / (before - modal));
    before = modal;
    timeBefore = state.time;
  }
  const double first = energy[0] / weight[0];
  result.kept = energy[10] / weight[10] / first;
  result.swing = std::max(largest - first, first - smallest) / first;
  EXPECT_GE(crossings.size(), 21u);
  result.period = crossings.size() > 20 ? (crossings[20] - crossings[0]) / 10.0 : 0.0;
  return result;
}

constexpr double kh = pi / cells;
const double smoothing = (5.0 + 3.0 * std::cos(kh)) / 8.0;
const double lumped = 2.0 * std::sin(0.5 * kh);

void check(const Vibration& v, const std::string& scheme, const std::string& shape)
{
  const double ideal = 2.0 * length;
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
  EXPECT_NEAR(v.kept, 1.0, 1e-3);
  // Velocity and strain are half a step apart, so that the energy swings by sin(w t) cos(w t) w dt.
  EXPECT_NEAR(v.swing, 0.5 * kh * v.dt, 0.1 * 0.5 * kh * v.dt);
  EXPECT_NEAR(v.period, discrete, 1e-4 * discrete);
  EXPECT_NEAR(v.period / ideal - 1.0, longer, 0.02 * longer);
}

class Bar : public testing::TestWithParam<std::tuple<std::string, std::string>>
{
};

} // namespace

TEST_P(Bar, KeepsEnergyAndPeriodInThePlane)
{
  check(vibrate<2>(std::get<0>(GetParam()), std::get<1>(GetParam())), std::get<0>(GetParam()),
        std::get<1>(GetParam()));
}

TEST_P(Bar, KeepsEnergyAndPeriodInSpace)
{
  check(vibrate<3>(std::get<0>(GetParam()), std::get<1>(GetParam())), std::get<0>(GetParam()),
        std::get<1>(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(FreeVibration, Bar,
                         testing::Combine(testing::Values("MUSL", "USF", "USL"),
                                          testing::Values("Linear", "GIMP")),
                         CaseName());

} // namespace Test
} // namespace Rhegma
