/// What the energy balance says of fine cells that move in substeps: the work of supports, loads and gravity.

#include "../../src/step/Bodies.hpp"
#include "state/EnergySums.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace Rhegma
{
namespace Test
{

namespace
{

constexpr double speed = 1e-5; // of walls; waves are of about 1 m/s and cells of 1 m

/// A block of 6 by 2 cells, refined at its left end.
Teuchos::ParameterList blockScene(int levels, bool substeps)
{
  Teuchos::ParameterList scene =
      emptyScene<2>(Vector<2>{{-2.0, -2.0}}, Vector<2>{{8.0, 4.0}}, 1.0, "MUSL", "GIMP");
  scene.sublist("Time").set("CFL", 0.4);
  addMaterial(scene, "Neo-Hookean", 0.3);
  addBox<2>(scene, "Block", all<2>(0.0), Vector<2>{{6.0, 2.0}});
  Teuchos::ParameterList& adaptivity = scene.sublist("Adaptivity");
  adaptivity.set("Maximum Level", levels);
  adaptivity.set("Interval", 1000000);
  Teuchos::ParameterList& box = adaptivity.sublist("Left End");
  box.set("Lower Corner", array(Vector<2>{{-0.5, -0.5}}));
  box.set("Upper Corner", array(Vector<2>{{0.5, 2.5}}));
  box.set("Level", levels);
  if (substeps)
    scene.sublist("Sub-Cycling").set("Levels", levels);
  return scene;
}

/// A wall that moves the left end along x. \param history of its speed
Teuchos::ParameterList withWall(Teuchos::ParameterList scene, const char* history)
{
  Teuchos::ParameterList& wall = scene.sublist("Boundaries").sublist("Wall");
  wall.set("Type", "Velocity");
  wall.set("Lower Corner", array(Vector<2>{{-2.0, -2.0}}));
  wall.set("Upper Corner", array(Vector<2>{{0.0, 4.0}}));
  wall.set("Value", array(Vector<2>{{speed, 0.0}}));
  wall.set("Components", "x");
  wall.set("History", history);
  return scene;
}

/// A traction that pulls the left end.
Teuchos::ParameterList withLoad(Teuchos::ParameterList scene)
{
  Teuchos::ParameterList& pull = scene.sublist("Boundaries").sublist("Pull");
  pull.set("Type", "Traction");
  pull.set("Body", "Block");
  pull.set("From", array(Vector<2>{{0.0, 0.0}}));
  pull.set("To", array(Vector<2>{{0.0, 2.0}}));
  pull.set("Stress", array(Vector<2>{{-speed, 0.0}}));
  return scene;
}

/// Residual of the energy balance of a run, and the most that supports and loads gave within one of its steps
/// [J].
struct Balance
{
  double mean = 0.0; ///< residual over the last fifth of the time
  double step = 0.0;
};

Balance balanceOf(const Teuchos::ParameterList& scene, double end)
{
  Rhegma::Run<2> run(validated(scene));
  run.initialize();
  State<2>& state = run.state();
  Balance balance;
  double time = 0.0;
  while (state.clock.time < end)
  {
    const double before = state.energy.externalWork;
    run.step(end, false);
    measureEnergy(state);
    balance.step = std::max(balance.step, std::fabs(state.energy.externalWork - before));
    if (state.clock.time < 0.8 * end)
      continue;
    balance.mean += state.clock.dt * state.energy.residual();
    time += state.clock.dt;
  }
  balance.mean /= time;
  return balance;
}

/// The residual after one step from rest [J].
double afterOneStep(const Teuchos::ParameterList& scene, double* length)
{
  Rhegma::Run<2> run(validated(scene));
  run.initialize();
  run.step(1e9, false);
  measureEnergy(run.state());
  *length = run.state().clock.dt;
  return run.state().energy.residual();
}

class SubcycledBalance : public testing::TestWithParam<int>
{
};

} // namespace

/// Velocities are half a substep behind stresses. So a wall that begins to move at once may leave open
/// half of what it gives in a substep: its speed times that of a plane wave times that of the wall, 2 m
/// wide.
TEST_P(SubcycledBalance, knowsWhatAWallGivesInTheFirstStep)
{
  const double wave = std::sqrt(0.7 / (1.3 * 0.4)); // [m/s]
  double length = 0.0;
  const double open = afterOneStep(withWall(blockScene(GetParam(), true), "1"), &length);
  const double subcycled = std::ldexp(length, -GetParam());
  std::printf("%d levels, wall: open after a step %.2e J of %.2e J that the wall gives\n", GetParam(), open,
              2.0 * wave * speed * speed * length);
  EXPECT_LT(std::fabs(open), 0.5 * 2.0 * wave * speed * speed * subcycled);
}

/// The balance is accurate to half a step; its mean residual is that where all cells take substeps, but for
/// half of what the wall gives in a step. (One level of fine cells hardly shows waves of a period of 6 s: the
/// steps themselves take a fifth of their energy.)
TEST_P(SubcycledBalance, knowsWhatAWallGivesThatGoesToAndFro)
{
  for (const char* history : {"1", "sin(pi*t/12)", "sin(pi*t/3)"})
  {
    if (std::string(history) == "sin(pi*t/3)" && GetParam() == 1)
      continue;
    const Balance subcycled = balanceOf(withWall(blockScene(GetParam(), true), history), 60.0);
    const Balance all = balanceOf(withWall(blockScene(GetParam(), false), history), 60.0);
    std::printf("%d levels, wall %s: open in the mean %.2e J, in substeps only %.2e, half a step %.2e\n",
                GetParam(), history, subcycled.mean, all.mean, 0.5 * subcycled.step);
    EXPECT_NEAR(subcycled.mean, all.mean, 0.5 * subcycled.step) << history;
  }
}

/// Mass damping takes at once, at the start of a step, what substeps have half of their stresses'
/// work on: that of the first of them.
TEST_P(SubcycledBalance, knowsWhatStrongDampingDissipates)
{
  Balance balance[2];
  for (const bool subcycled : {false, true})
  {
    Teuchos::ParameterList scene = withWall(blockScene(GetParam(), subcycled), "sin(pi*t/12)");
    scene.sublist("Damping").set("Mass Rate", 1.0);
    balance[subcycled] = balanceOf(scene, 60.0);
  }
  std::printf("%d levels, damped: open in the mean %.2e J, in substeps only %.2e, half a step %.2e\n",
              GetParam(), balance[true].mean, balance[false].mean, 0.5 * balance[true].step);
  EXPECT_NEAR(balance[true].mean, balance[false].mean, 0.5 * balance[true].step);
}

/// A load acts continuously, so that its work is accurate to half of that in a substep.
TEST_P(SubcycledBalance, knowsTheWorkOfALoad)
{
  const Balance some = balanceOf(withLoad(blockScene(GetParam(), true)), 60.0);
  const Balance all = balanceOf(withLoad(blockScene(GetParam(), false)), 60.0);
  const double half = 0.5 * std::ldexp(some.step, -GetParam());
  std::printf("%d levels, load: open in the mean %.2e J, in substeps only %.2e, half a step %.2e\n",
              GetParam(), some.mean, all.mean, half);
  EXPECT_NEAR(some.mean, all.mean, half);
}

/// Gravity pulls nodes of fine cells all through a step and moves others at its start, so that in N steps
/// their velocities come to differ by half of what a step gives: a fraction of 1 / 2N, which has the square
/// of that fraction of the energy. The rest of it is the work of gravity.
TEST_P(SubcycledBalance, knowsTheWorkOfGravity)
{
  constexpr int steps = 50;
  Teuchos::ParameterList scene = blockScene(GetParam(), true);
  Teuchos::ParameterList& gravity = scene.sublist("Boundaries").sublist("Earth");
  gravity.set("Type", "Gravity");
  gravity.set("Acceleration", array(Vector<2>{{1e-6, -2e-6}}));
  Rhegma::Run<2> run(validated(scene));
  run.initialize();
  State<2>& state = run.state();
  for (int k = 0; k < steps; ++k)
    run.step(1e9, false);
  measureEnergy(state);
  EXPECT_GT(state.energy.kinetic, 0.0);
  EXPECT_NEAR(state.energy.externalWork, state.energy.kinetic, state.energy.kinetic / (4.0 * steps * steps));
}

INSTANTIATE_TEST_SUITE_P(SubCycling, SubcycledBalance, testing::Values(1, 2, 3, 4));

} // namespace Test
} // namespace Rhegma
