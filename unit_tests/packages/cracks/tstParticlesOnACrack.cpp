/// A crack that runs through the centres of particles.

#include "../../src/step/Bodies.hpp"

#include <cmath>

namespace Rhegma
{
namespace Test
{

/// Rounding puts centres a little above or below the crack; all of them lie on one side. With front springs
/// the crack would divide these particles.
TEST(ParticlesOnACrack, LieOnOneSide)
{
  const double cell = 1e-3;
  Teuchos::ParameterList scene =
      emptyScene<2>(all<2>(-2.0 * cell), all<2>(32.0 * cell), cell, "MUSL", "GIMP");
  addMaterial(scene, "Linear Elastic", 0.3);
  addBox<2>(scene, "Block", all<2>(0.0), all<2>(30.0 * cell));
  Teuchos::ParameterList& cracks = scene.sublist("Cracks");
  cracks.set("Front Springs", false);
  const double height[] = {0.00525, 0.01525, 0.02525};
  for (const double y : height)
    cracks.sublist("Crack at " + std::to_string(y))
        .set("Points", Teuchos::Array<double>(Teuchos::tuple(0.0125, y, 0.0175, y)));
  Rhegma::Run<2> run(validated(scene));
  run.initialize();
  run.step(1e30, false);
  const HostParticles<2> particles(run.state());
  const auto side = onHost(run.state().particles.integer(fields::side));
  int on = 0;
  for (int p = 0; p < particles.size; ++p)
    for (int c = 0; c < 3; ++c)
      if (std::fabs(particles.position(p, 1) - height[c]) < 1e-9 * cell && particles.position(p, 0) > 0.013 &&
          particles.position(p, 0) < 0.017)
      {
        ++on;
        EXPECT_EQ(side(p), c + 1);
      }
  EXPECT_EQ(on, 3 * 8); // four cells of each row, two particles a cell
}

} // namespace Test
} // namespace Rhegma
