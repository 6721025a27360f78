/// A body with a crack that flies through its cells, which refine around the front as it comes: nothing
/// happens to it.

#include "../../src/step/Bodies.hpp"

#include <cmath>
#include <string>

namespace Rhegma
{
namespace Test
{

/// Functions sum to one, across levels and next to the crack, so that a uniform velocity stays what it is and
/// strains nothing; round-off of some hundred steps.
TEST(MovingCrack, FliesWithoutAForce)
{
  for (const char* formulation : {"Dual Field", "Broken Cell"})
    for (const char* shape : {"Linear", "GIMP"})
    {
      Teuchos::ParameterList scene =
          emptyScene<2>(Vector<2>{{-3.0, -3.0}}, Vector<2>{{18.0, 14.0}}, 1.0, "MUSL", shape);
      addMaterial(scene, "Neo-Hookean", 0.3);
      const Vector<2> speed{{0.05, 0.03}};
      addBox<2>(scene, "Plate", all<2>(0.0), Vector<2>{{10.0, 8.0}}).set("Velocity", array(speed));
      scene.sublist("Adaptivity").set("Maximum Level", 2);
      scene.sublist("Cracks").set("Formulation", formulation);
      scene.sublist("Cracks").sublist("Notch").set(
          "Points", Teuchos::Array<double>(Teuchos::tuple(0.0, 4.1, 4.8, 4.3)));
      Rhegma::Run<2> run(validated(scene));
      run.initialize();
      State<2>& state = run.state();
      ASSERT_EQ(state.cracks.fronts.size(), 1u);
      const Vector<2> start = state.cracks.fronts[0].position;
      const int generation = state.mesh.tree.generation;
      const auto massOf = [&state]
      {
        const HostParticles<2> particles(state);
        double sum = 0.0;
        for (int p = 0; p < particles.size; ++p)
          sum += particles.mass(p);
        return sum;
      };
      const double mass = massOf();
      while (state.clock.time < 50.0) // two cells and a half
        run.step(50.0, false);
      EXPECT_GT(state.mesh.tree.generation, generation + 3);
      const Vector<2> front = state.cracks.fronts[0].position;
      const TreeSight<2> sight(state.mesh.grid, state.mesh.tree);
      EXPECT_EQ(sight.spacingAt(front), 0.25);
      EXPECT_EQ(sight.spacingAt(Vector<2>{{start[0] - 2.0, start[1]}}), 1.0) << "small cells stayed behind";
      EXPECT_NEAR(massOf(), mass, 1e-12 * mass);
      for (int d = 0; d < 2; ++d)
        EXPECT_NEAR(front[d], start[d] + 50.0 * speed[d], 1e-11) << formulation << " " << shape;
      const HostParticles<2> particles(state);
      for (int p = 0; p < particles.size; ++p)
        for (int d = 0; d < 2; ++d)
        {
          ASSERT_NEAR(particles.velocity(p, d), speed[d], 1e-12) << formulation << " " << shape;
          ASSERT_NEAR(particles.deformation(p, 3 * d), 1.0, 1e-11);
        }
    }
}

} // namespace Test
} // namespace Rhegma
