#pragma once
/// Bodies at random positions and at angles to the lattice, shaken, and the conservation of their energy.

#include "../../../src/step/Bodies.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <random>
#include <sstream>
#include <vector>

namespace Rhegma
{
namespace Test
{

/// The defaults of the section Mass Matrix.
struct Settings
{
  double lumpedFraction = 0.1, smallestNode = 0.1, tolerance = 1e-7;
};

/// Where a body lies: its middle next to a node of the lattice [cells], and its angle [degrees].
struct Pose
{
  Vector<2> offset;
  double angle;
};

constexpr double poisson = 0.3;
constexpr int allSteps = 100000;
constexpr int sampleEvery = 50;
constexpr double length = 4.0, height = 2.0; ///< of a body [cells]
/// Cells between the middles of bodies: they have no common nodes. A diagonal of 4.5, boxes of GIMP that
/// reach 1.25 cells beyond particles to nodes on either side, and positions that differ by up to 1.
constexpr double apart = 9.0;

inline bool everything()
{
  const char* asked = std::getenv("RHEGMA_STABILITY");
  return asked != nullptr && *asked != 0;
}

/// Whether bodies at an angle are among those that RHEGMA_STABILITY asks for.
inline bool asksFor(double angle)
{
  const std::string asked = std::getenv("RHEGMA_STABILITY");
  return asked == "all" || std::stod(asked) == angle;
}

/// Bodies that are tried together: each day one at each of two angles, else as many as `count` at one angle.
/// Those with cracks are tried one by one, as what damping takes is the sum of all springs.
/// \param count at each angle \param cracked whether bodies have cracks
inline std::vector<std::vector<Pose>> poses(int count, bool cracked = false)
{
  const std::vector<double> angles =
      everything() ? std::vector<double>{0.0, 11.0, 22.5, 37.0, 45.0} : std::vector<double>{11.0, 45.0};
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> within(0.0, 1.0);
  std::vector<std::vector<Pose>> groups;
  for (const double angle : angles)
  {
    if (everything() || groups.empty())
      groups.emplace_back();
    for (int k = 0; k < count; ++k)
    {
      const double x = within(generator);
      groups.back().push_back({Vector<2>{{x, within(generator)}}, angle});
    }
  }
  if (everything())
    groups.erase(std::remove_if(groups.begin(), groups.end(),
                                [](const std::vector<Pose>& group) { return !asksFor(group.front().angle); }),
                 groups.end());
  if (!cracked)
    return groups;
  std::vector<std::vector<Pose>> single;
  for (const std::vector<Pose>& group : groups)
    for (const Pose& pose : group)
      single.push_back({pose});
  return single;
}

/// Bodies with E, density and cell of 1. With Partial each has a crack halfway along it.
inline Teuchos::ParameterList bodiesScene(const std::string& type, const std::string& shape,
                                          const std::vector<Pose>& bodies, const Settings& settings)
{
  const int across = static_cast<int>(std::ceil(std::sqrt(double(bodies.size()))));
  const int rows = (static_cast<int>(bodies.size()) + across - 1) / across;
  Teuchos::ParameterList scene = emptyScene<2>(
      Vector<2>{{-5.0, -5.0}}, Vector<2>{{across * apart - 3.0, rows * apart - 3.0}}, 1.0, "MUSL", shape);
  addMaterial(scene, "Linear Elastic", poisson);
  scene.sublist("Time").set("CFL", 0.3);
  Teuchos::ParameterList& mass = scene.sublist("Mass Matrix");
  mass.set("Type", type);
  if (type != "Lumped")
  {
    mass.set("Lumped Fraction", settings.lumpedFraction);
    mass.set("Minimum Node Mass", settings.smallestNode);
    mass.set("Solver Tolerance", settings.tolerance);
    mass.set("Maximum Iterations", 2000);
  }
  if (type == "Partial")
  {
    mass.set("Radius", 1.0);
    mass.set("Transition Width", 0.7);
  }
  for (std::size_t k = 0; k < bodies.size(); ++k)
  {
    const Pose& pose = bodies[k];
    const std::size_t column = k % across, row = k / across;
    const double x = apart * static_cast<double>(column) + pose.offset[0],
                 y = apart * static_cast<double>(row) + pose.offset[1];
    addBox<2>(scene, "Body " + std::to_string(k), Vector<2>{{x - 0.5 * length, y - 0.5 * height}},
              Vector<2>{{x + 0.5 * length, y + 0.5 * height}})
        .set("Rotation", pose.angle);
    if (type != "Partial")
      continue;
    const double c = 0.5 * length * std::cos(pose.angle * M_PI / 180.0),
                 s = 0.5 * length * std::sin(pose.angle * M_PI / 180.0);
    scene.sublist("Cracks")
        .sublist("Slit " + std::to_string(k))
        .set("Points", Teuchos::Array<double>(std::vector<double>{x - c, y - s, x, y}));
  }
  return scene;
}

/// How bodies move [m/s]; a cell is 1 m.
struct Motion
{
  double shaking = 1e-9;          ///< so little that no particle reaches another cell
  Vector<2> flight = Vector<2>{}; ///< of all particles, next to the shaking
};

/// Random velocities of the particles: every motion that they have is there, but bodies do not spin, and move
/// with the given velocity.
inline void shake(State<2>& state, std::size_t bodies, const Motion& motion)
{
  HostParticles<2> particles(state);
  const auto body = onHost(state.particles.integer(fields::body));
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> number(-motion.shaking, motion.shaking);
  for (int p = 0; p < particles.size; ++p)
    for (int d = 0; d < 2; ++d)
      particles.velocity(p, d) = number(generator);
  std::vector<double> mass(bodies), inertia(bodies), spin(bodies);
  std::vector<Vector<2>> middle(bodies, Vector<2>{}), mean(bodies, Vector<2>{});
  const auto each = [&](const auto& work)
  {
    for (int p = 0; p < particles.size; ++p)
      work(p, body(p), particles.mass(p));
  };
  const auto arm = [&](int p, int b, int d) { return particles.position(p, d) - middle[b][d]; };
  each([&](int, int b, double m) { mass[b] += m; });
  each(
      [&](int p, int b, double m)
      {
        for (int d = 0; d < 2; ++d)
        {
          middle[b][d] += m / mass[b] * particles.position(p, d);
          mean[b][d] += m / mass[b] * particles.velocity(p, d);
        }
      });
  each(
      [&](int p, int b, double m)
      {
        const double x = arm(p, b, 0), y = arm(p, b, 1);
        inertia[b] += m * (x * x + y * y);
        spin[b] += m * (x * particles.velocity(p, 1) - y * particles.velocity(p, 0));
      });
  each(
      [&](int p, int b, double)
      {
        const double turn = spin[b] / inertia[b];
        particles.velocity(p, 0) += motion.flight[0] - mean[b][0] + turn * arm(p, b, 1);
        particles.velocity(p, 1) += motion.flight[1] - mean[b][1] - turn * arm(p, b, 0);
      });
  particles.store(state);
}

/// The strain energy of each body; strains are small and plane: its density is (1 + nu) / 2E (s:s - nu (tr
/// s)^2), s the stress in the plane.
inline std::vector<double> strainEnergies(const State<2>& state, std::size_t bodies)
{
  const HostParticles<2> particles(state);
  const auto body = onHost(state.particles.integer(fields::body));
  const auto volume = onHost(state.particles.scalar(fields::volume));
  std::vector<double> sum(bodies, 0.0);
  for (int p = 0; p < particles.size; ++p)
  {
    const double sx = particles.stress(p, symmetricIndex<2>(0, 0)),
                 sy = particles.stress(p, symmetricIndex<2>(1, 1)),
                 sxy = particles.stress(p, symmetricIndex<2>(0, 1));
    sum[body(p)] += volume(p) * 0.5 * (1.0 + poisson) *
                    (sx * sx + sy * sy + 2.0 * sxy * sxy - poisson * (sx + sy) * (sx + sy));
  }
  return sum;
}

/// The velocity of each particle next to that of the flight, by the numbers that particles keep.
inline std::vector<Vector<2>> velocities(const State<2>& state, const Vector<2>& flight)
{
  const HostParticles<2> particles(state);
  const auto id = onHost(state.particles.integer(fields::id));
  std::vector<Vector<2>> all(particles.size);
  for (int p = 0; p < particles.size; ++p)
    for (int d = 0; d < 2; ++d)
      all[id(p)][d] = particles.velocity(p, d) - flight[d];
  return all;
}

/// One step. \return of each body the energy that the steps keep: strain energy before the step, and half of
/// m v w with the velocities v before and w after it. With a crack the body must be alone: the energy of
/// springs at its front and what their damping has taken, at the middle of the step, count, too.
///
/// With w = v - dt A* s and s' = s + dt A w, A any fixed operator and s the stress in a measure whose square
/// is twice the strain energy, v w + s s is the same in all steps; v v + s s wavers about it with twice the
/// frequency of each mode, and samples of it can waver as slowly as they please.
inline std::vector<double> energiesOfStep(Rhegma::Run<2>& run, std::size_t bodies, const Vector<2>& flight)
{
  const State<2>& state = run.state();
  std::vector<double> sum = strainEnergies(state, bodies);
  const double springs = state.energy.springs, taken = state.energy.stabilised;
  const std::vector<Vector<2>> before = velocities(state, flight);
  run.step(1e30, false);
  const std::vector<Vector<2>> after = velocities(state, flight);
  const auto body = onHost(state.particles.integer(fields::body));
  const auto id = onHost(state.particles.integer(fields::id));
  const auto mass = onHost(state.particles.scalar(fields::mass));
  for (int p = 0; p < state.particles.size(); ++p)
    sum[body(p)] += 0.5 * mass(p) * (before[id(p)][0] * after[id(p)][0] + before[id(p)][1] * after[id(p)][1]);
  EXPECT_TRUE(bodies == 1 || state.energy.stabilised == 0.0);
  sum[0] += springs + 0.5 * (taken + state.energy.stabilised);
  return sum;
}

constexpr int parts = 10;

/// Of each body the mean energy over each tenth of the steps, next to that over the first; infinite where the
/// run stops, or where a body's energy grows a hundredfold. Means, as next to a crack the energy of single
/// steps wavers.
using History = std::vector<std::array<double, parts>>;

inline History follow(const Teuchos::ParameterList& scene, std::size_t bodies, int steps,
                      const Motion& motion = Motion{})
{
  std::array<double, parts> infinite;
  infinite.fill(std::numeric_limits<double>::infinity());
  History unbounded(bodies, infinite);
  Rhegma::Run<2> run(validated(scene));
  run.initialize();
  shake(run.state(), bodies, motion);
  std::vector<double> first;
  History history(bodies, std::array<double, parts>{});
  try
  {
    for (int k = 0; k < steps; ++k)
    {
      if (k % sampleEvery != 0)
      {
        run.step(1e30, false);
        continue;
      }
      const std::vector<double> now = energiesOfStep(run, bodies, motion.flight);
      if (k == 0)
        first = now;
      for (std::size_t b = 0; b < bodies; ++b)
      {
        if (!(std::abs(now[b]) < 100.0 * first[b]))
          return unbounded;
        history[b][k / (steps / parts)] += now[b];
      }
    }
  }
  catch (const RunError&)
  {
    return unbounded;
  }
  for (std::array<double, parts>& means : history)
  {
    const double early = means.front();
    for (double& mean : means)
      mean /= early;
  }
  return history;
}

/// What is left in the end.
inline std::vector<double> ends(const History& history)
{
  std::vector<double> all;
  for (const auto& means : history)
    all.push_back(means.back());
  return all;
}

inline std::ostream& operator<<(std::ostream& out, const Pose& pose)
{
  return out << "at (" << pose.offset[0] << ", " << pose.offset[1] << "), " << pose.angle << " degrees";
}

/// Smallest and largest of them, as words.
inline std::string range(const std::vector<double>& numbers)
{
  const auto [least, most] = std::minmax_element(numbers.begin(), numbers.end());
  std::ostringstream text;
  text.precision(6);
  text << *least << " to " << *most;
  return text.str();
}

} // namespace Test
} // namespace Rhegma
