/// Heat in equilibrium: thermal strain, and steps of conduction that are tried again.

#include "material/Tensors.hpp"
#include "src/step/Bodies.hpp"
#include "thermal/RepeatedStep.hpp"

namespace Rhegma
{
namespace Test
{

namespace
{

constexpr double expansion = 1e-3; ///< [1/K]

/// A free block in quasi-static equilibrium.
template <int D>
Teuchos::ParameterList warmBlock(double initial)
{
  Teuchos::ParameterList scene = emptyScene<D>(all<D>(-4.0), all<D>(8.0), 1.0, "MUSL", "GIMP", "Stress");
  scene.sublist("Time").set("Analysis", "Quasi-Static");
  scene.sublist("Time").set("Rigid Modes", "Remove");
  scene.sublist("Time").set("Final Time", 1.0);
  scene.sublist("Time").set("Load Steps", 4);
  addMaterial(scene, "Neo-Hookean", 0.3);
  Teuchos::ParameterList& solid = scene.sublist("Materials").sublist("Solid");
  solid.set("Specific Heat", 1e3); // so large that strain changes no temperature
  solid.set("Conductivity", 10.0);
  solid.set("Thermal Expansion", expansion);
  solid.set("Reference Temperature", 300.0);
  addBox<D>(scene, "Block", all<D>(0.3), all<D>(4.3));
  scene.sublist("Thermal").set("Initial Temperature", initial);
  return scene;
}

/// A free body that is warmer by dT expands by alpha dT and has no stress.
template <int D>
void testFreeExpansion()
{
  const double rise = 10.0;
  Rhegma::Run<D> run(validated(warmBlock<D>(300.0 + rise)));
  run.initialize();
  while (run.state().clock.time < 1.0)
    run.step(1.0, false);
  const HostParticles<D> particles(run.state());
  for (int p = 0; p < particles.size; ++p)
    for (int d = 0; d < D; ++d)
    {
      ASSERT_NEAR(particles.deformation(p, d * (D + 1)), 1.0 + expansion * rise, 2e-6);
      ASSERT_NEAR(particles.stress(p, symmetricIndex<D>(d, d)), 0.0, 2e-6); // of E = 1 and a strain of 1e-2
    }
}

} // namespace

TEST(HeatInEquilibrium, FreeBodiesExpand) { testFreeExpansion<2>(); }
TEST(HeatInEquilibrium, FreeBodiesExpand3D) { testFreeExpansion<3>(); }

/// Half a step that follows a whole one that failed leaves what half a step alone leaves.
TEST(HeatInEquilibrium, AStepThatIsTriedAgainConductsOnce)
{
  std::vector<double> after[2];
  for (const bool fails : {false, true})
  {
    Teuchos::ParameterList scene = warmBlock<2>(300.0);
    scene.sublist("Bodies").sublist("Block").set("Temperature Field", "300 + 20*x");
    Rhegma::Run<2> run(validated(scene));
    run.initialize();
    State<2>& state = run.state();
    thermal::Conduction<2> conduction;
    conduction.measure(state);
    thermal::RepeatedStep<2> repeated;
    for (const double dt : {0.2, 0.1})
      if (fails || dt == 0.1)
      {
        state.clock.dt = dt;
        repeated.begin(state, conduction);
        conduction.step(state);
      }
    const auto T = onHost(state.particles.scalar(fields::temperature));
    after[fails ? 1 : 0].assign(T.data(), T.data() + state.particles.size());
    EXPECT_EQ(conduction.pending, 0.0);
  }
  ASSERT_EQ(after[0].size(), after[1].size());
  double spread = 0.0;
  for (std::size_t p = 0; p < after[0].size(); ++p)
  {
    EXPECT_EQ(after[0][p], after[1][p]) << "particle " << p;
    spread = std::max(spread, std::fabs(after[0][p] - after[0][0]));
  }
  EXPECT_GT(spread, 1.0); // there is something to conduct
}

} // namespace Test
} // namespace Rhegma
