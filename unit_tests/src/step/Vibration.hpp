#pragma once
/// A bar that vibrates freely, for tests of what steps make of its energy and of its period.

#include "Bodies.hpp"
#include "Pi.hpp"
#include "state/EnergySums.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma
{
namespace Test
{

/// The bar lies along x from 0 with cells of 1 m, waves of 1 m/s and free ends.
using Rhegma::Test::pi;
constexpr int barCells = 16;
constexpr double barAmplitude = 1e-5; ///< of its velocity [m/s]

struct Vibration
{
  double kept = 0.0;   ///< mean energy of the eleventh period over that of the first
  double swing = 0.0;  ///< largest difference of the energy from its mean in the first period, over it
  double period = 0.0; ///< mean of ten [s]
  double dt = 0.0;
};

/// The scene of the bar, two cells high.
template <int D>
Teuchos::ParameterList barScene(const std::string& scheme, const std::string& shape)
{
  Vector<D> lower = all<D>(-2.0), upper = all<D>(4.0), end = all<D>(2.0);
  upper[0] = barCells + 2.0;
  end[0] = barCells;
  Teuchos::ParameterList scene = emptyScene<D>(lower, upper, 1.0, scheme, shape);
  addMaterial(scene, "Linear Elastic", 0.0);
  addBox<D>(scene, "Bar", all<D>(0.0), end);
  return scene;
}

/// Mode j of the bar at x as linear functions between nodes have it.
inline double modeAt(double x, int j)
{
  const double k = pi * j / barCells;
  const double node = std::floor(x), s = x - node;
  return (1.0 - s) * std::cos(k * node) + s * std::cos(k * (node + 1.0));
}

/// Lets the bar vibrate in mode j for eleven periods. \param average time over which energies are averaged, a
/// period or nearly [s]
template <int D>
Vibration vibrate(const Teuchos::ParameterList& scene, int j, double average)
{
  Rhegma::Run<D> run(validated(scene));
  run.initialize();
  State<D>& state = run.state();
  const auto numbers = [&state] { return onHost(state.particles.integer(fields::id)); };
  std::vector<double> mode(state.particles.size());
  {
    const HostParticles<D> particles(state);
    const auto id = numbers();
    for (int p = 0; p < particles.size; ++p)
    {
      mode[id(p)] = modeAt(particles.position(p, 0), j);
      particles.velocity(p, 0) = barAmplitude * mode[id(p)];
    }
    particles.store(state);
  }

  Vibration result;
  std::vector<double> crossings;
  double energy[11] = {}, weight[11] = {}, largest = 0.0, smallest = 1e300;
  double before = barAmplitude, timeBefore = 0.0;
  while (state.clock.time < 11.0 * average || (crossings.size() < 21 && state.clock.time < 13.0 * average))
  {
    run.step(1e30, false);
    result.dt = state.clock.dt;
    measureEnergy(state);
    const double now = state.energy.kinetic + state.energy.strain;
    const int n = static_cast<int>(state.clock.time / average);
    if (n < 11)
    {
      energy[n] += state.clock.dt * now;
      weight[n] += state.clock.dt;
    }
    if (n == 0)
    {
      largest = std::max(largest, now);
      smallest = std::min(smallest, now);
    }
    const HostParticles<D> particles(state);
    const auto id = numbers();
    double modal = 0.0;
    for (int p = 0; p < particles.size; ++p)
      modal += particles.mass(p) * mode[id(p)] * particles.velocity(p, 0);
    if (modal * before < 0.0)
      crossings.push_back(timeBefore + (state.clock.time - timeBefore) * before / (before - modal));
    before = modal;
    timeBefore = state.clock.time;
  }
  const double first = energy[0] / weight[0];
  result.kept = energy[10] / weight[10] / first;
  result.swing = std::max(largest - first, first - smallest) / first;
  EXPECT_GE(crossings.size(), 21u);
  result.period = crossings.size() > 20 ? (crossings[20] - crossings[0]) / 10.0 : 0.0;
  return result;
}

} // namespace Test
} // namespace Rhegma
