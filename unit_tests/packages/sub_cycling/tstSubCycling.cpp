/// Bars that vibrate freely while the small cells in their middle take short steps: energy, momentum, and the
/// motion of the same bar in short steps only.

#include "../../src/step/Bodies.hpp"

#include "output/CoreRow.hpp"

#include <functional>
#include <random>

namespace Rhegma
{
namespace Test
{

namespace
{

constexpr double pi = 3.14159265358979323846;
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
  double mode = 0.0; ///< share of the first mode in the end
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
  const auto id =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.particles.integer(fields::id));
  const auto reference = Kokkos::create_mirror_view_and_copy(
      Kokkos::HostSpace{}, state.particles.template real<D>(fields::reference));
  std::vector<double> mode(particles.size);
  for (int p = 0; p < particles.size; ++p)
    mode[id(p)] = std::cos(pi * reference(p, 0) / length);
  return mode;
}

template <int D>
void start(State<D>& state, Start kind)
{
  const HostParticles<D> particles(state);
  const auto reference = Kokkos::create_mirror_view_and_copy(
      Kokkos::HostSpace{}, state.particles.template real<D>(fields::reference));
  std::mt19937 engine(4);
  std::uniform_real_distribution<double> some(-1.0, 1.0);
  for (int p = 0; p < particles.size; ++p)
    for (int d = 0; d < D; ++d)
      particles.velocity(p, d) = amplitude * (kind == Start::Random ? some(engine)
                                              : d == 0              ? std::cos(pi * reference(p, 0) / length)
                                                                    : 0.0);
  particles.store(state);
}

template <int D>
Outcome vibrate(int levels, bool subCycled, Start kind, double cfl, int periods, const char* shape = "GIMP",
                const Addition& addition = {})
{
  Rhegma::Run<D> run = bar<D>(levels, subCycled, cfl, 0.0, shape, addition);
  State<D>& state = run.state();
  start(state, kind);
  const std::vector<double> mode = modeOf(state);
  const HostParticles<D> first(state);
  double mass = 0.0;
  for (int p = 0; p < first.size; ++p)
    mass += first.mass(p);
  measureEnergy(state);
  const Vector<D> momentum = state.momentum;
  Outcome outcome;
  const double period = 2.0 * length;
  double energy[2] = {}, weight[2] = {};
  while (state.time < periods * period)
  {
    run.step(periods * period, false);
    measureEnergy(state);
    const double now = state.energy.kinetic + state.energy.strain;
    outcome.most = std::max(outcome.most, now);
    const double time = state.time;
    const int when = time < period ? 0 : (time > (periods - 1) * period ? 1 : -1);
    if (when >= 0)
    {
      energy[when] += state.dt * now;
      weight[when] += state.dt;
    }
    for (int d = 0; d < D; ++d)
      outcome.momentum =
          std::max(outcome.momentum, std::fabs(state.momentum[d] - momentum[d]) / (mass * amplitude));
  }
  outcome.kept = energy[1] / weight[1] * weight[0] / energy[0];
  outcome.most *= weight[0] / energy[0];
  outcome.steps = state.step;
  const HostParticles<D> last(state);
  if (addition)
    return outcome; // cells may have changed
  EXPECT_EQ(last.size, first.size);
  const auto id =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.particles.integer(fields::id));
  double square = 0.0;
  for (int p = 0; p < last.size; ++p)
  {
    outcome.mode += last.mass(p) * mode[id(p)] * last.velocity(p, 0);
    square += last.mass(p) * mode[id(p)] * mode[id(p)];
  }
  outcome.mode /= square * amplitude;
  return outcome;
}

class Levels : public testing::TestWithParam<int>
{
};

} // namespace

TEST_P(Levels, keepEnergyOverTenPeriods)
{
  const Outcome o = vibrate<2>(GetParam(), true, Start::Smooth, 0.4, 10);
  std::printf("%d levels: energy kept %.6f, most %.6f, momentum %.1e, %ld steps\n", GetParam(), o.kept,
              o.most, o.momentum, o.steps);
  EXPECT_NEAR(o.kept, 1.0, 1e-3);
  EXPECT_LT(o.most, 1.06); // a bar of equal cells swings as much: tstFreeVibration
  EXPECT_LT(o.momentum, 1e-12);
}

/// Every particle with a velocity of its own is the motion that feeds an unstable coupling of levels most.
TEST_P(Levels, holdFromARandomStart)
{
  const Outcome o = vibrate<2>(GetParam(), true, Start::Random, 0.4, 10);
  std::printf("%d levels, random: energy kept %.6f, most %.6f, momentum %.1e\n", GetParam(), o.kept, o.most,
              o.momentum);
  EXPECT_NEAR(o.kept, 1.0, 0.03);
  EXPECT_LT(o.most, 1.05);
  EXPECT_LT(o.momentum, 1e-12);
}

TEST_P(Levels, holdWithLinearFunctions)
{
  const Outcome o = vibrate<2>(GetParam(), true, Start::Random, 0.3, 10, "Linear");
  std::printf("%d levels, linear, random: energy kept %.6f, most %.6f, momentum %.1e\n", GetParam(), o.kept,
              o.most, o.momentum);
  EXPECT_NEAR(o.kept, 1.0, 0.03);
  EXPECT_LT(o.most, 1.06);
  EXPECT_LT(o.momentum, 1e-12);
}

TEST_P(Levels, moveAsInShortStepsOnly)
{
  const Outcome sub = vibrate<2>(GetParam(), true, Start::Smooth, 0.4, 1);
  const Outcome all = vibrate<2>(GetParam(), false, Start::Smooth, 0.4, 1);
  std::printf("%d levels: mode %.6f %.6f most %.6f %.6f kept %.6f steps %ld %ld\n", GetParam(), sub.mode,
              all.mode, sub.most, all.most, sub.kept, sub.steps, all.steps);
  EXPECT_NEAR(sub.mode, all.mode, 0.002);
  EXPECT_GT(all.steps, ((1 << GetParam()) - 1) * sub.steps);
}

/// A crack along the left half of the bar, and the matrix that couples the nodes round its front. (Without
/// the lower CFL number that the matrix asks for in short steps three levels gain 8 % in 100 periods.)
void addCrackAndPartialMass(Teuchos::ParameterList& scene)
{
  scene.sublist("Mass Matrix").set("Type", "Partial");
  scene.sublist("Cracks").sublist("Split").set(
      "Points", Teuchos::Array<double>(Teuchos::tuple(0.0, 1.0, 0.5 * length, 1.0)));
}

TEST_P(Levels, keepEnergyWithAMatrixRoundACrackFront)
{
  for (const Start kind : {Start::Smooth, Start::Random})
  {
    const Outcome o = vibrate<2>(GetParam(), true, kind, 0.4, 10, "GIMP", addCrackAndPartialMass);
    std::printf("%d levels, partial mass, %s: energy kept %.6f, most %.6f, momentum %.1e\n", GetParam(),
                kind == Start::Smooth ? "smooth" : "random", o.kept, o.most, o.momentum);
    EXPECT_NEAR(o.kept, 1.0, kind == Start::Smooth ? 1e-3 : 0.03);
    EXPECT_LT(o.most, 1.06);
    EXPECT_LT(o.momentum, 1e-12);
  }
}

/// The bar vibrates as it flies through cells that stay small where they are: its particles split before
/// them and become one again behind. What it keeps of the energy of its vibration, beside what merging took,
/// is that of the same flight in short steps only.
TEST_P(Levels, keepEnergyInFlight)
{
  const double periods = 2.0;
  const auto kept = [&](bool subCycled)
  {
    const double speed = 0.1, travel = speed * periods * 2.0 * length;
    Rhegma::Run<2> run = bar<2>(GetParam(), subCycled, 0.4, travel);
    State<2>& state = run.state();
    start(state, Start::Smooth);
    const auto vibration = [&]
    {
      measureEnergy(state);
      double mass = 0.0;
      const HostParticles<2> particles(state);
      for (int p = 0; p < particles.size; ++p)
        mass += particles.mass(p);
      const double flight = 0.5 * dot(state.momentum, state.momentum) / mass;
      return state.energy.kinetic + state.energy.strain - flight + state.energy.merged;
    };
    HostParticles<2> particles(state);
    for (int p = 0; p < particles.size; ++p)
      particles.velocity(p, 0) += speed;
    particles.store(state);
    const double first = vibration();
    double sum = 0.0, time = 0.0;
    const double period = 2.0 * length;
    while (state.time < periods * period)
    {
      run.step(periods * period, false);
      if (state.time <= (periods - 1.0) * period)
        continue;
      sum += state.dt * vibration();
      time += state.dt;
    }
    return sum / time / first;
  };
  const double sub = kept(true), all = kept(false);
  std::printf("%d levels in flight: energy kept %.6f, in short steps only %.6f\n", GetParam(), sub, all);
  EXPECT_NEAR(sub, all, 0.005);
}

/// A wall holds nodes of small cells: supports take nodes to their velocity once a long step, and what
/// particles feel of that belongs to the motion of short steps; without it three levels made any energy.
TEST_P(Levels, holdBesideASupport)
{
  Teuchos::ParameterList scene =
      emptyScene<2>(Vector<2>{{-2.0, -2.0}}, Vector<2>{{6.0, 4.0}}, 1.0, "MUSL", "GIMP");
  scene.sublist("Time").set("CFL", 0.4);
  addMaterial(scene, "Neo-Hookean", 0.3);
  addBox<2>(scene, "Block", all<2>(0.0), Vector<2>{{4.0, 2.0}});
  Teuchos::ParameterList& wall = scene.sublist("Boundaries").sublist("Wall");
  wall.set("Type", "Symmetry");
  wall.set("Axis", "x");
  wall.set("Position", 0.0);
  wall.set("Side", "Lower");
  Teuchos::ParameterList& adaptivity = scene.sublist("Adaptivity");
  adaptivity.set("Maximum Level", GetParam());
  adaptivity.set("Interval", 1000000);
  Teuchos::ParameterList& box = adaptivity.sublist("At the Wall");
  box.set("Lower Corner", array(Vector<2>{{-0.5, 0.5}}));
  box.set("Upper Corner", array(Vector<2>{{0.5, 1.5}}));
  box.set("Level", GetParam());
  scene.sublist("Sub-Cycling").set("Levels", GetParam());
  Rhegma::Run<2> run(validated(scene));
  run.initialize();
  State<2>& state = run.state();
  start(state, Start::Random);
  measureEnergy(state);
  const double given = state.energy.kinetic;
  double most = 0.0;
  for (int k = 0; k < 1000; ++k)
  {
    run.step(1e9, false);
    measureEnergy(state);
    most = std::max(most, state.energy.kinetic + state.energy.strain);
  }
  std::printf("%d levels beside a support: energy %.4f of what was given, most %.4f\n", GetParam(),
              (state.energy.kinetic + state.energy.strain) / given, most / given);
  // A support takes energy and gives none; kinetic and strain energy waver as in a free bar.
  EXPECT_LT(most, 1.06 * given);
}

INSTANTIATE_TEST_SUITE_P(SubCycling, Levels, testing::Values(1, 2, 3, 4));

TEST(SubCycling, keepsEnergyIn3D)
{
  const Outcome o = vibrate<3>(2, true, Start::Smooth, 0.4, 2);
  EXPECT_NEAR(o.kept, 1.0, 1e-3);
  EXPECT_LT(o.momentum, 1e-12);
}

} // namespace Test
} // namespace Rhegma
