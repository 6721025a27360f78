/// A velocity that varies over space, prescribed at the nodes of cells that change.

#include "../../src/step/Bodies.hpp"

#include <cmath>

namespace Rhegma
{
namespace Test
{

namespace
{

/// All nodes stretch along x; the criterion refines all cells in step 1, and a box is finer from the start.
/// Every particle then has the same deformation in every step.
template <int D>
void checkEvenStretch()
{
  Teuchos::ParameterList scene = emptyScene<D>(all<D>(-3.0), all<D>(7.0), 1.0, "MUSL", "GIMP");
  addMaterial(scene, "Neo-Hookean", 0.3);
  addBox<D>(scene, "Block", all<D>(0.0), all<D>(4.0));
  Teuchos::ParameterList& held = scene.sublist("Boundaries").sublist("Held");
  held.set("Type", "Velocity");
  held.set("Lower Corner", array(all<D>(-3.0)));
  held.set("Upper Corner", array(all<D>(7.0)));
  held.set("Field", D == 2 ? "0.01*x, -0.002*y" : "0.01*x, -0.002*y, 0.001*x");
  Teuchos::ParameterList& adaptivity = scene.sublist("Adaptivity");
  adaptivity.set("Maximum Level", 2);
  adaptivity.set("Velocity Change", 0.009);
  Teuchos::ParameterList& box = adaptivity.sublist("Box");
  box.set("Lower Corner", array(all<D>(1.0)));
  box.set("Upper Corner", array(all<D>(2.0)));
  box.set("Level", 2);
  Run<D> run(validated(scene));
  run.initialize();
  State<D>& state = run.state();
  const int generation = state.mesh.tree.generation;
  double stretch = 1.0;
  for (int k = 0; k < 20; ++k)
  {
    run.step(1e30, false);
    stretch *= 1.0 + 0.01 * state.clock.dt;
    const HostParticles<D> particles(state);
    for (int p = 0; p < particles.size; ++p)
      ASSERT_NEAR(particles.deformation(p, 0), stretch, 1e-13);
  }
  EXPECT_GT(state.mesh.tree.generation, generation);
  EXPECT_EQ(state.mesh.tree.deepest, 2);
}

} // namespace

TEST(PrescribedOnTree, stretchesEvenlyIn2D) { checkEvenStretch<2>(); }
TEST(PrescribedOnTree, stretchesEvenlyIn3D) { checkEvenStretch<3>(); }

} // namespace Test
} // namespace Rhegma
