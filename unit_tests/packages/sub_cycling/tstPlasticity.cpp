/// Metal that flows while fine cells take substeps, moved by supports.

#include "../../src/step/Bodies.hpp"
#include "state/EnergySums.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace Rhegma
{
namespace Test
{

namespace
{

template <int D>
Teuchos::ParameterList metalBlock(int levels, bool substeps)
{
  Vector<D> upper = all<D>(2.0);
  upper[0] = 6.0;
  Vector<D> end = all<D>(5.0);
  end[0] = 9.0;
  Teuchos::ParameterList scene = emptyScene<D>(all<D>(-3.0), end, 1.0, "MUSL", "GIMP");
  addMaterial(scene, "J2 Plastic", 0.3);
  scene.sublist("Materials").sublist("Solid").set("Yield Stress", 0.01);
  scene.sublist("Materials").sublist("Solid").set("Hardening Modulus", 0.1);
  addBox<D>(scene, "Block", all<D>(0.0), upper);
  Teuchos::ParameterList& adaptivity = scene.sublist("Adaptivity");
  adaptivity.set("Maximum Level", levels);
  adaptivity.set("Interval", 1000000);
  Teuchos::ParameterList& box = adaptivity.sublist("Box");
  Vector<D> from = all<D>(0.5), to = all<D>(1.5);
  from[0] = 2.5;
  to[0] = 3.5;
  box.set("Lower Corner", array(from));
  box.set("Upper Corner", array(to));
  box.set("Level", levels);
  if (substeps)
    scene.sublist("Sub-Cycling").set("Levels", levels);
  return scene;
}

/// A velocity that grows with the position is prescribed at all nodes, those of fine cells in substeps too.
/// Each particle's deformation is the product of the steps', and all have flowed alike, whatever substeps
/// tried of the law in between. The balance is accurate to half a step, and the work of the walls is largest
/// in the first one.
template <int D>
void checkEvenFlow(int levels)
{
  const double rate = 0.01;
  Teuchos::ParameterList scene = metalBlock<D>(levels, true);
  Teuchos::ParameterList& held = scene.sublist("Boundaries").sublist("Held");
  held.set("Type", "Velocity");
  held.set("Lower Corner", array(all<D>(-3.0)));
  held.set("Upper Corner", array(all<D>(9.0)));
  held.set("Field", D == 2 ? "0.01*x, 0" : "0.01*x, 0, 0");
  Run<D> run(validated(scene));
  run.initialize();
  State<D>& state = run.state();
  double stretch = 1.0, step = 0.0;
  for (int k = 0; k < 20; ++k)
  {
    const double before = state.energy.externalWork;
    run.step(1e30, false);
    stretch *= 1.0 + rate * state.clock.dt;
    step = std::max(step, std::fabs(state.energy.externalWork - before));
  }
  ASSERT_EQ(state.mesh.tree.deepest, levels);
  const HostParticles<D> particles(state);
  const auto history = onHost(state.particles.table(fields::history));
  for (int p = 0; p < particles.size; ++p)
  {
    ASSERT_NEAR(particles.deformation(p, 0), stretch, 1e-13);
    ASSERT_NEAR(particles.stress(p, 0), particles.stress(0, 0), 1e-13);
    for (std::size_t k = 0; k < history.extent(1); ++k)
      ASSERT_NEAR(history(p, k), history(0, k), 1e-12);
  }
  measureEnergy(state);
  EXPECT_GT(stretch, 1.03) << "three times the strain at which it yields";
  EXPECT_GT(state.energy.plastic, 0.0);
  std::printf("%dD, %d levels: open %.3e J, half of the first step %.3e, plastic %.3e\n", D, levels,
              state.energy.residual(), 0.5 * step, state.energy.plastic);
  EXPECT_LT(std::fabs(state.energy.residual()), 0.5 * step);
}

} // namespace

TEST(SubcycledPlasticity, FlowEvenlyIn2D)
{
  for (const int levels : {1, 2, 3})
    checkEvenFlow<2>(levels);
}

TEST(SubcycledPlasticity, FlowEvenlyIn3D) { checkEvenFlow<3>(2); }

/// Two walls squeeze the block, and it flows round the fine cells in its middle. The balance, with plastic
/// work, is accurate to half a step: its final residual is that where all cells take substeps, but for half
/// of the most that the walls give in a step.
TEST(SubcycledPlasticity, KeepTheEnergyBalance)
{
  for (const int levels : {1, 2, 3})
  {
    double open[2], plastic[2], step = 0.0;
    for (const bool subcycled : {true, false})
    {
      Teuchos::ParameterList scene = metalBlock<2>(levels, subcycled);
      for (const int end : {0, 1})
      {
        Teuchos::ParameterList& wall = scene.sublist("Boundaries").sublist("Wall " + std::to_string(end));
        wall.set("Type", "Velocity");
        wall.set("Lower Corner", array(Vector<2>{{end == 0 ? -3.0 : 6.0, -3.0}}));
        wall.set("Upper Corner", array(Vector<2>{{end == 0 ? 0.0 : 9.0, 5.0}}));
        wall.set("Components", "x");
        wall.set("Value", array(Vector<2>{{end == 0 ? 0.02 : -0.02, 0.0}}));
      }
      Rhegma::Run<2> run(validated(scene));
      run.initialize();
      State<2>& state = run.state();
      while (state.clock.time < 12.0)
      {
        const double before = state.energy.externalWork;
        run.step(12.0, false);
        if (subcycled)
          step = std::max(step, std::fabs(state.energy.externalWork - before));
      }
      measureEnergy(state);
      open[subcycled ? 0 : 1] = state.energy.residual();
      plastic[subcycled ? 0 : 1] = state.energy.plastic;
    }
    std::printf("%d levels, plastic: open %.3e J, in substeps only %.3e, half a step %.3e; plastic work %.5e "
                "J, %.5e\n",
                levels, open[0], open[1], 0.5 * step, plastic[0], plastic[1]);
    EXPECT_GT(plastic[0], 10.0 * step);
    EXPECT_NEAR(open[0], open[1], 0.5 * step);
  }
}

} // namespace Test
} // namespace Rhegma
