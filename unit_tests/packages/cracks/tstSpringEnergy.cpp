/// What the damping of front springs takes, in the energy balance: bodies with a crack, shaken at random.

#include "cracks/CohesiveLaw.hpp"
#include "src/step/Bodies.hpp"
#include "state/EnergySums.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <string>

namespace Rhegma::cracks
{

namespace
{

using Test::all;

constexpr double shaking = 1e-6; ///< of the particles [m/s]; waves have 1 m/s, cells 1 m

/// A block anywhere in its cells, and a crack from outside to its middle, whose last nodes have springs.
/// \param past by how far the front lies past a node [cells], or at random
template <int D>
Teuchos::ParameterList crackedBlock(const std::string& scheme, double cfl, std::mt19937& random,
                                    std::optional<double> past = {})
{
  std::uniform_real_distribution<double> within(0.0, 1.0);
  Vector<D> lower, upper = all<D>(4.0);
  for (int d = 0; d < D; ++d)
  {
    lower[d] = within(random);
    upper[d] += lower[d];
  }
  Teuchos::ParameterList scene = Test::emptyScene<D>(all<D>(-3.0), all<D>(8.0), 1.0, scheme, "GIMP");
  scene.sublist("Time").set("CFL", cfl);
  Test::addMaterial(scene, "Linear Elastic", 0.3);
  Test::addBox<D>(scene, "Block", lower, upper);
  const double from = lower[0] - 1.0,
               to = std::floor(lower[0] + 2.0) + (past ? *past : 0.2 + 0.6 * within(random)),
               at = lower[D - 1] + 1.5 + within(random);
  const double front = lower[1] - 1.0, back = upper[1] + 1.0;
  const std::vector<double> points =
      D == 2 ? std::vector<double>{from, at, to, at}
             : std::vector<double>{from, front, at, to, front, at, to, back, at, from, back, at};
  scene.sublist("Cracks").sublist("Slit").set("Points", Teuchos::Array<double>(points));
  return scene;
}

/// Gives all particles a velocity of their own, or one that opens the crack as a bending mode does.
template <int D>
void start(State<D>& state, bool smooth, std::mt19937& random)
{
  std::uniform_real_distribution<double> number(-shaking, shaking);
  const Test::HostParticles<D> particles(state);
  for (int p = 0; p < particles.size; ++p)
    for (int d = 0; d < D; ++d)
      particles.velocity(p, d) = !smooth      ? number(random)
                                 : d == D - 1 ? shaking * std::cos(0.7 * particles.position(p, 0)) *
                                                    std::sin(0.7 * (particles.position(p, D - 1) - 2.0))
                                              : 0.0;
  particles.store(state);
}

/// Half of the sum of m v w over the particles, v before and w after a step [J]. \param before by their ids
template <int D>
double mixedKinetic(const State<D>& state, const std::vector<Vector<D>>& before)
{
  const Test::HostParticles<D> particles(state);
  const auto id = onHost(state.particles.integer(fields::id));
  double sum = 0.0;
  for (int p = 0; p < particles.size; ++p)
    for (int d = 0; d < D; ++d)
      sum += 0.5 * particles.mass(p) * before[id(p)][d] * particles.velocity(p, d);
  return sum;
}

template <int D>
std::vector<Vector<D>> velocitiesOf(const State<D>& state)
{
  const Test::HostParticles<D> particles(state);
  const auto id = onHost(state.particles.integer(fields::id));
  std::vector<Vector<D>> all(particles.size);
  for (int p = 0; p < particles.size; ++p)
    for (int d = 0; d < D; ++d)
      all[id(p)][d] = particles.velocity(p, d);
  return all;
}

/// Of a run: what damping took, by how much the energy changed beyond that, and the most of a step [J]; what
/// it took over the energy at the start.
struct Taken
{
  double taken = 0.0, open = 0.0, most = 0.0, fraction = 0.0;
};

/// A step velocity first, w = v - dt A* s, then s' = s + dt A w, keeps v w + s s; with a damping force the
/// mean of its works on w in this step and the next is lost. So the energy of the middle of the step, with
/// half of what this step took, stays the same up to half of what a step takes.
template <int D>
Taken follow(const std::string& scheme, bool smooth, double cfl, int steps)
{
  const unsigned seed = std::random_device{}();
  std::mt19937 random(seed);
  Rhegma::Run<D> run(Test::validated(crackedBlock<D>(scheme, cfl, random)));
  run.initialize();
  State<D>& state = run.state();
  start(state, smooth, random);
  Taken result;
  double first = 0.0, change = 0.0;
  for (int k = 0; k < steps; ++k)
  {
    const std::vector<Vector<D>> before = velocitiesOf(state);
    const double taken = state.energy.stabilised;
    measureEnergy(state);
    const double strain = state.energy.strain;
    run.step(1e30, false);
    measureEnergy(state);
    double now = (scheme == "USF" ? state.energy.strain : strain) + mixedKinetic(state, before) +
                 0.5 * (taken + state.energy.stabilised);
    if (scheme == "USAVG") // half of the strain before, half after: as of a step that is central
      now = state.energy.kinetic + state.energy.strain + state.energy.stabilised;
    if (k == 0)
      first = now;
    change = now - first;
    result.open = std::max(result.open, std::fabs(change));
    result.most = std::max(result.most, std::fabs(state.energy.stabilised - taken));
  }
  result.taken = state.energy.stabilised;
  result.fraction = result.taken / first;
  std::printf(
      "%s, %dD, seed %u: taken %.4f of the energy, open by %.2e, %+.2e in the end, the most of a step %.2e\n",
      scheme.c_str(), D, seed, result.taken / first, result.open / first, change / first,
      result.most / first);
  return result;
}

/// The same of a body whose fronts have springs: at some positions in their cells they have none, or soft
/// ones that take less than the schemes lose by themselves.
template <int D>
Taken followSprings(const std::string& scheme, bool smooth, double cfl, int steps)
{
  Taken result;
  for (int draw = 0; draw < 20 && !(result.fraction > 0.05); ++draw)
    result = follow<D>(scheme, smooth, cfl, steps);
  return result;
}

template <int D>
void keepsTheBalance()
{
  const Taken result = followSprings<D>("MUSL", false, 0.3, 400);
  EXPECT_GT(result.taken, 10.0 * result.most);
  EXPECT_LT(result.open, result.most);
}

template <int D>
void closes(const std::string& scheme)
{
  const Taken result = followSprings<D>(scheme, true, 0.05, 800);
  EXPECT_GT(result.taken, 0.0);
  EXPECT_LT(result.open, 0.1 * result.taken);
}

/// The most that the energy of particles and springs is over that at the start, in a long run in
/// large steps, with the front a little past a node that is ahead by the lag of the law: the stiffest
/// springs.
template <int D>
double gained(const std::string& scheme, double past, int steps)
{
  const unsigned seed = std::random_device{}();
  std::mt19937 random(seed);
  Rhegma::Run<D> run(Test::validated(crackedBlock<D>(scheme, 0.8, random, past)));
  run.initialize();
  State<D>& state = run.state();
  start(state, false, random);
  measureEnergy(state);
  const double first = state.energy.kinetic;
  double most = 0.0, least = 0.0;
  for (int k = 0; k < steps; ++k)
  {
    run.step(1e30, false);
    if (k % 10 != 0)
      continue;
    measureEnergy(state);
    most = std::max(most, state.energy.kinetic + state.energy.strain);
    least = std::min(least, state.energy.stabilised);
  }
  std::printf("%s, %dD, %.3f cells past a node, seed %u: at most %.3f of the energy, damping took %.3f\n",
              scheme.c_str(), D, past, seed, most / first, state.energy.stabilised / first);
  if (scheme != "USF") // of which the record is wrong in large steps (docs/explanation/cracks.md)
  {
    EXPECT_GE(least, -1e-3 * first);
  }
  return most / first;
}

/// Velocity and stress are those of different times: of a motion of frequency w the sum of their energies is
/// at most 1 / (1 - (w dt / 2)^2) times that at the start, and w dt / 2 is at most the CFL number.
template <int D>
void staysBounded(const std::string& scheme, int steps)
{
  const double ahead = splitAhead<D>(1.0, 0.0, FrontLaw{true, true});
  for (const double past : {0.0, 1.0 - ahead + 0.004, 1.0 - ahead + 0.05})
    EXPECT_LT(gained<D>(scheme, past, steps), 1.0 / (1.0 - 0.64))
        << scheme << ", " << past << " cells past a node";
}

} // namespace

TEST(SpringEnergy, IsThatOfTheKineticEnergyIn2D) { keepsTheBalance<2>(); }
TEST(SpringEnergy, IsThatOfTheKineticEnergyIn3D) { keepsTheBalance<3>(); }

/// In short steps, as velocities of the solve count where no step ends with a projection. USL is left out:
/// by itself, where no spring takes any, it loses half of the energy of such bodies in that time.
class SpringEnergyOfSchemes : public testing::TestWithParam<const char*>
{
};

TEST_P(SpringEnergyOfSchemes, StaysInTheBalanceIn2D) { closes<2>(GetParam()); }
TEST_P(SpringEnergyOfSchemes, StaysInTheBalanceIn3D) { closes<3>(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Schemes, SpringEnergyOfSchemes, testing::Values("MUSL", "USF", "USAVG"));

/// In steps of a CFL number of 0.8 with springs that are hundreds of times too stiff for them. With inertia
/// on forces alone the energy grows by 0.1 % to 1 % a step.
class StiffSprings : public testing::TestWithParam<const char*>
{
};

TEST_P(StiffSprings, AreStableIn2D) { staysBounded<2>(GetParam(), 10000); }
TEST_P(StiffSprings, AreStableIn3D) { staysBounded<3>(GetParam(), 2000); }

INSTANTIATE_TEST_SUITE_P(Schemes, StiffSprings, testing::Values("MUSL", "USF", "USAVG"));

} // namespace Rhegma::cracks
