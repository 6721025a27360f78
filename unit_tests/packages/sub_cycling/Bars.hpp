#pragma once
/// Bars that vibrate freely while the fine cells in their middle take substeps.

#include "../../src/step/Bodies.hpp"
#include "Pi.hpp"

#include "state/EnergySums.hpp"

#include <functional>
#include <random>

namespace Rhegma
{
namespace Test
{

using Rhegma::Test::pi;
constexpr double length = 12.0; // cells of 1 m, waves of 1 m/s
constexpr double amplitude = 1e-5;

enum class Start
{
  Smooth, ///< the bar's first mode
  Random  ///< a velocity of its own for every particle
};

struct Outcome
{
  double kept = 0.0;     ///< mean energy of the last period over that of the first
  double most = 0.0;     ///< largest energy over the mean of the first period
  double momentum = 0.0; ///< largest, over mass times amplitude
  long steps = 0;
  double mode = 0.0; ///< fraction of the first mode in the end
};

/// What a test adds to a scene.
using Addition = std::function<void(Teuchos::ParameterList&)>;

template <int D>
Rhegma::Run<D> bar(int levels, bool subCycled, double cfl, double travel = 0.0, const char* shape = "GIMP",
                   const Addition& addition = {})
{
  Vector<D> lower = all<D>(-2.0), upper = all<D>(4.0), end = all<D>(2.0);
  upper[0] = length + travel + 2.0;
  end[0] = length;
  Teuchos::ParameterList scene = emptyScene<D>(lower, upper, 1.0, "MUSL", shape);
  scene.sublist("Time").set("CFL", cfl);
  addMaterial(scene, "Neo-Hookean", 0.0);
  addBox<D>(scene, "Bar", all<D>(0.0), end);
  Teuchos::ParameterList& adaptivity = scene.sublist("Adaptivity");
  adaptivity.set("Maximum Level", levels);
  adaptivity.set("Interval", travel > 0.0 ? 1 : 1000000);
  Teuchos::ParameterList& box = adaptivity.sublist("Middle");
  Vector<D> from = all<D>(0.5), to = all<D>(1.5);
  from[0] = 0.5 * length - 0.5;
  to[0] = 0.5 * length + 0.5;
  box.set("Lower Corner", array(from));
  box.set("Upper Corner", array(to));
  box.set("Level", levels);
  if (subCycled)
    scene.sublist("Sub-Cycling").set("Levels", levels);
  if (addition)
    addition(scene);
  Rhegma::Run<D> run(validated(scene));
  run.initialize();
  return run;
}

template <int D>
std::vector<double> modeOf(const State<D>& state)
{
  const HostParticles<D> particles(state);
  const auto id = onHost(state.particles.integer(fields::id));
  const auto reference = onHost(state.particles.template real<D>(fields::reference));
  std::vector<double> mode(particles.size);
  for (int p = 0; p < particles.size; ++p)
    mode[id(p)] = std::cos(pi * reference(p, 0) / length);
  return mode;
}

template <int D>
void start(State<D>& state, Start kind)
{
  const HostParticles<D> particles(state);
  const auto reference = onHost(state.particles.template real<D>(fields::reference));
  std::mt19937 engine(4);
  std::uniform_real_distribution<double> some(-1.0, 1.0);
  for (int p = 0; p < particles.size; ++p)
    for (int d = 0; d < D; ++d)
      particles.velocity(p, d) = amplitude * (kind == Start::Random ? some(engine)
                                              : d == 0              ? std::cos(pi * reference(p, 0) / length)
                                                                    : 0.0);
  particles.store(state);
}

/// Amplitude of the first mode in the velocity now.
template <int D>
double fractionOfMode(const State<D>& state)
{
  const std::vector<double> mode = modeOf(state);
  const HostParticles<D> particles(state);
  const auto id = onHost(state.particles.integer(fields::id));
  double sum = 0.0, square = 0.0;
  for (int p = 0; p < particles.size; ++p)
  {
    sum += particles.mass(p) * mode[id(p)] * particles.velocity(p, 0);
    square += particles.mass(p) * mode[id(p)] * mode[id(p)];
  }
  return sum / (square * amplitude);
}

template <int D>
Outcome vibrate(int levels, bool subCycled, Start kind, double cfl, int periods, const char* shape = "GIMP",
                const Addition& addition = {})
{
  Rhegma::Run<D> run = bar<D>(levels, subCycled, cfl, 0.0, shape, addition);
  State<D>& state = run.state();
  start(state, kind);
  const HostParticles<D> first(state);
  double mass = 0.0;
  for (int p = 0; p < first.size; ++p)
    mass += first.mass(p);
  measureEnergy(state);
  const Vector<D> momentum = state.sample.momentum;
  Outcome outcome;
  const double period = 2.0 * length;
  double energy[2] = {}, weight[2] = {};
  while (state.clock.time < periods * period)
  {
    run.step(periods * period, false);
    measureEnergy(state);
    const double now =
        state.energy.kinetic + state.energy.strain + state.energy.thermal + state.energy.stabilised;
    outcome.most = std::max(outcome.most, now);
    const double time = state.clock.time;
    const int when = time < period ? 0 : (time > (periods - 1) * period ? 1 : -1);
    if (when >= 0)
    {
      energy[when] += state.clock.dt * now;
      weight[when] += state.clock.dt;
    }
    for (int d = 0; d < D; ++d)
      outcome.momentum =
          std::max(outcome.momentum, std::fabs(state.sample.momentum[d] - momentum[d]) / (mass * amplitude));
  }
  outcome.kept = energy[1] / weight[1] * weight[0] / energy[0];
  outcome.most *= weight[0] / energy[0];
  outcome.steps = state.clock.step;
  if (!addition) // else cells may have changed
  {
    EXPECT_EQ(state.particles.size(), first.size);
    outcome.mode = fractionOfMode(state);
  }
  return outcome;
}

} // namespace Test
} // namespace Rhegma
