/// Reflection of a pulse at faces between cells of different size.
///
/// In a bar waves go at 1 m/s (no lateral strain: Poisson's ratio is 0). It starts with a pulse that runs to
/// the right: velocity A cos^2(pi x / w) over a width w, strain the opposite. The bar is refined beyond a
/// face, or before it. Before the face a bar of equal cells moves in the same way until something comes back
/// from the face, so the difference of the two, particle by particle, is what was reflected: the pulse's own
/// tail, and whatever the start left behind, is in both.
///
/// Bounded is the fraction of energy that comes back, as it is for pulses at closed cracks, when all of the
/// pulse lies within 8 coarse cells: waves of 8 cells and less are most of it, and lattices of h and h / 2
/// differ most in their stiffness for these. Of a pulse twice as long, 8 cells at half its height, the
/// amplitude is bounded too: the largest difference of velocity over the largest velocity.

#include "../../src/step/Bodies.hpp"
#include "Pi.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

namespace Rhegma
{
namespace Test
{

namespace
{

using Rhegma::Test::pi;
constexpr double length = 120.0; ///< of the bar [m], cells of 1 m
constexpr double face = 72.0;    ///< the first position where the cells change [m]
constexpr double apart = 6.0;    ///< from one face to the next [m]
/// [s] Short waves at a fifth of the speed of long ones have passed the first face; nothing that comes back
/// has reached the left end, and what came back from the right one is far from the face.
constexpr double until = 60.0;
constexpr double height = 1e-6; ///< A [m/s]

double hump(double x, double width)
{
  return std::fabs(x) < 0.5 * width ? std::pow(std::cos(pi * x / width), 2) : 0.0;
}

/// Levels before the first face, between the faces, beyond the last.
using Levels = std::vector<int>;

Run<2> bar(const Levels& levels, double cfl, const std::string& shape)
{
  Teuchos::ParameterList scene =
      emptyScene<2>(Vector<2>{{-2.0, -2.0}}, Vector<2>{{length + 2.0, 4.0}}, 1.0, "MUSL", shape);
  scene.sublist("Time").set("CFL", cfl);
  addMaterial(scene, "Linear Elastic", 0.0);
  addBox<2>(scene, "Bar", Vector<2>{{0.0, 0.0}}, Vector<2>{{length, 2.0}});
  const int deepest = *std::max_element(levels.begin(), levels.end());
  for (std::size_t k = 0; k < levels.size(); ++k)
    if (levels[k] > 0)
    {
      Teuchos::ParameterList& adaptivity = scene.sublist("Adaptivity");
      adaptivity.set("Maximum Level", deepest);
      Teuchos::ParameterList& box = adaptivity.sublist("Part " + std::to_string(k));
      const double from = k == 0 ? -2.0 : face + apart * (k - 1);
      const double to = k + 1 == levels.size() ? length + 2.0 : face + apart * k;
      box.set("Lower Corner", array(Vector<2>{{from, -2.0}}));
      box.set("Upper Corner", array(Vector<2>{{to, 4.0}}));
      box.set("Level", levels[k]);
    }
  Run<2> run(validated(scene));
  run.initialize();
  return run;
}

/// Particles before the first face, by where they were at first.
struct Moving
{
  double velocity, mass;
};
using Before = std::map<std::pair<long, long>, Moving>;

struct Passed
{
  Before before;
  double energy = 0.0, peak = 0.0; ///< of all particles: twice the kinetic energy, largest velocity
};

Passed pass(const Levels& levels, double cfl, double width, const std::string& shape)
{
  Run<2> run = bar(levels, cfl, shape);
  State<2>& state = run.state();
  {
    const double start = face - 0.5 * width - 2.0;
    const HostParticles<2> particles(state);
    for (int p = 0; p < particles.size; ++p)
    {
      const double v = height * hump(particles.position(p, 0) - start, width);
      particles.velocity(p, 0) = v;
      particles.deformation(p, 0) = 1.0 - v;
      particles.stress(p, 0) = -v;
    }
    particles.store(state);
  }
  while (state.clock.time < until)
    run.step(until, false);
  Passed passed;
  const HostParticles<2> particles(state);
  const auto reference = onHost(state.particles.real<2>(fields::reference));
  for (int p = 0; p < particles.size; ++p)
  {
    const double v = particles.velocity(p, 0);
    passed.energy += particles.mass(p) * v * v;
    passed.peak = std::max(passed.peak, std::fabs(v));
    if (reference(p, 0) < face)
      passed.before[{std::lround(64.0 * reference(p, 0)), std::lround(64.0 * reference(p, 1))}] = {
          v, particles.mass(p)};
  }
  return passed;
}

/// Fractions of those of the pulse.
struct Energies
{
  double amplitude = 0.0, energy = 0.0;
};

/// What comes back. \param levels of which the first is that of the equal cells
Energies reflected(const Levels& levels, double width, const std::string& shape = "GIMP")
{
  const int deepest = *std::max_element(levels.begin(), levels.end());
  const Passed with = pass(levels, 0.4, width, shape);
  // Steps are of the smallest cells: the same ones in both.
  const Passed without = pass({levels.front()}, std::ldexp(0.4, levels.front() - deepest), width, shape);
  EXPECT_EQ(with.before.size(), without.before.size());
  Energies fraction;
  for (const auto& particle : without.before)
  {
    const auto same = with.before.find(particle.first);
    if (same == with.before.end())
    {
      ADD_FAILURE() << "no such particle";
      break;
    }
    const double difference = same->second.velocity - particle.second.velocity;
    fraction.amplitude = std::max(fraction.amplitude, std::fabs(difference) / without.peak);
    fraction.energy += particle.second.mass * difference * difference / without.energy;
  }
  std::string name;
  for (const int level : levels)
    name += " " + std::to_string(level);
  std::printf("levels%s, %s, pulse of %g cells: reflected energy %.4f %%, amplitude %.2f %%\n", name.c_str(),
              shape.c_str(), width, 100.0 * fraction.energy, 100.0 * fraction.amplitude);
  return fraction;
}

} // namespace

TEST(Reflection, OfAPulseOf8CellsIsBelowAPercentAtAFace)
{
  EXPECT_LT(reflected({0, 1}, 8.0).energy, 0.01);
  EXPECT_LT(reflected({1, 0}, 8.0).energy, 0.01);
  EXPECT_LT(reflected({0, 1}, 8.0, "Linear").energy, 0.01);
}

TEST(Reflection, OfAPulseOf8CellsIsBelowOneAndAHalfPercentAtTwoFaces)
{
  EXPECT_LT(reflected({0, 1, 2}, 8.0).energy, 0.015);
  EXPECT_LT(reflected({2, 1, 0}, 8.0).energy, 0.015);
  EXPECT_LT(reflected({0, 1, 0}, 8.0).energy, 0.015);
}

/// Lattices differ by a fraction of about (k h)^2 in how stiff waves find them, so half the wavenumber leaves
/// about a quarter.
TEST(Reflection, OfPulsesOf8CellsAtHalfHeightIsBelowAPercentOfAmplitude)
{
  const double one = reflected({0, 1}, 16.0).amplitude;
  EXPECT_LT(one, 0.01);
  EXPECT_LT(reflected({1, 0}, 16.0).amplitude, 0.01);
  EXPECT_LT(reflected({0, 1, 2}, 16.0).amplitude, 0.01);
  EXPECT_LT(reflected({2, 1, 0}, 16.0).amplitude, 0.01);
  EXPECT_LT(reflected({0, 1}, 32.0).amplitude, 0.5 * one);
}

} // namespace Test
} // namespace Rhegma
