/// A constant traction on a face that is refined: it is in balance with a uniform stress.

#include "Refined.hpp"

#include <cmath>
#include <cstdio>

namespace Rhegma
{
namespace Test
{

namespace
{

constexpr double pull = 1e-6; ///< [Pa], Young's modulus is 1 Pa

/// A block pulled at both ends along x, one end refined in its middle; no lateral strain.
template <int D>
Teuchos::ParameterList pulledBlock(int level)
{
  Teuchos::ParameterList scene = emptyScene<D>(all<D>(-3.0), all<D>(9.0), 1.0, "MUSL", "GIMP");
  addMaterial(scene, "Linear Elastic", 0.0);
  Vector<D> upper = all<D>(4.0);
  addBox<D>(scene, "Block", all<D>(0.0), upper);
  for (const int end : {0, 1})
  {
    Teuchos::ParameterList& load = scene.sublist("Boundaries").sublist("End " + std::to_string(end));
    load.set("Type", "Traction");
    load.set("Body", "Block");
    Vector<D> corner = all<D>(0.0), stress = all<D>(0.0);
    corner[0] = 4.0 * end;
    stress[0] = end == 0 ? -pull : pull;
    load.set("Stress", array(stress));
    for (int d = 1; d < D; ++d)
    {
      Vector<D> side = D == 2 ? corner : all<D>(0.0);
      side[d] = 4.0;
      load.set(D == 2 ? "To" : "Edge " + std::to_string(d), array(side));
    }
    load.set(D == 2 ? "From" : "Corner", array(corner));
  }
  Teuchos::ParameterList& adaptivity = scene.sublist("Adaptivity");
  adaptivity.set("Maximum Level", level);
  Teuchos::ParameterList& box = adaptivity.sublist("Box");
  Vector<D> from = all<D>(1.0), to = all<D>(3.0);
  from[0] = 3.0;
  to[0] = 5.0;
  box.set("Lower Corner", array(from));
  box.set("Upper Corner", array(to));
  box.set("Level", level);
  return scene;
}

/// Largest stress that steps add to the uniform one, over it.
template <int D>
double unevenness(int level, int steps)
{
  Run<D> run(validated(pulledBlock<D>(level)));
  run.initialize();
  State<D>& state = run.state();
  EXPECT_EQ(state.mesh.tree.deepest, level);
  {
    const HostParticles<D> particles(state);
    for (int p = 0; p < particles.size; ++p)
    {
      particles.deformation(p, 0) = 1.0 + pull;
      particles.stress(p, 0) = pull * (1.0 + pull);
    }
    particles.store(state);
  }
  for (int k = 0; k < steps; ++k)
    run.step(1e30, false);
  const HostParticles<D> particles(state);
  double most = 0.0;
  for (int p = 0; p < particles.size; ++p)
    for (int c = 0; c < symmetricSize<D>; ++c)
      most = std::max(most, std::fabs(particles.stress(p, c) - (c == 0 ? pull : 0.0)) / pull);
  std::printf("%dD, %d levels: stress off by %.1e\n", D, level, most);
  return most;
}

} // namespace

/// Positions and boxes are those before the pull, so that forces are out of balance by the fraction of the
/// strain, 1e-6 along each axis, and a sudden load is answered by twice the stress that balances it. Ends,
/// sides and the step at which a wave from one meets that from another each add such a fraction: ten are
/// many.
TEST(LoadedFace, isInBalanceWithAUniformStressIn2D)
{
  for (const int level : {1, 2, 3, 4})
    EXPECT_LT(unevenness<2>(level, 40), 10.0 * pull);
}

TEST(LoadedFace, isInBalanceWithAUniformStressIn3D) { EXPECT_LT(unevenness<3>(3, 10), 10.0 * pull); }

} // namespace Test
} // namespace Rhegma
