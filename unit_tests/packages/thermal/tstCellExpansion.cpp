/// Thermal strain in cells that cannot represent it: stresses of free bodies in a linear temperature.

#include "src/step/Bodies.hpp"
#include "thermal/CellExpansion.hpp"
#include "thermal/Start.hpp"
#include "transfer/ParticleViews.hpp"

#include <cmath>
#include <iostream>
#include <random>

namespace Rhegma
{
namespace Test
{

namespace
{

constexpr double alpha = 1e-7, start = 300.0; // so small that squares of strains do not count

/// A body of 6 m along each axis in cells of 1 m, E = 1 Pa. \param corner of the body
template <int D>
Teuchos::ParameterList body(const Vector<D>& corner, const std::string& shape, const std::string& plane,
                            double poisson)
{
  Teuchos::ParameterList scene =
      emptyScene<D>(corner - all<D>(5.0), corner + all<D>(16.0), 1.0, "MUSL", shape, plane);
  const Vector<D> origin = all<D>(-5.0); // nodes at whole numbers
  scene.sublist("Domain").set("Lower Corner", array(origin));
  scene.sublist("Domain").set("Upper Corner", array(all<D>(16.0)));
  addMaterial(scene, "Linear Elastic", poisson);
  Teuchos::ParameterList& solid = scene.sublist("Materials").sublist("Solid");
  solid.set("Specific Heat", 1e6); // straining does not change the temperature
  solid.set("Conductivity", 0.0);
  solid.set("Thermal Expansion", alpha);
  solid.set("Reference Temperature", start);
  scene.sublist("Thermal").set("Initial Temperature", start);
  addBox<D>(scene, "Body", corner, corner + all<D>(6.0));
  return scene;
}

template <int D>
Vector<D> randomVector(std::mt19937& random, double from, double to)
{
  std::uniform_real_distribution<double> between(from, to);
  Vector<D> v;
  for (int d = 0; d < D; ++d)
    v[d] = between(random);
  return v;
}

/// Free displacement of the temperature T0 + g . x above the reference, over alpha.
template <int D>
struct FreeDisplacement
{
  double T0;
  Vector<D> g;

  KOKKOS_INLINE_FUNCTION double temperature(const Vector<D>& x) const { return T0 + dot(g, x); }
  KOKKOS_INLINE_FUNCTION double operator()(const Vector<D>& x, int i) const
  {
    return x[i] * temperature(x) - 0.5 * g[i] * dot(x, x);
  }
};

/// Displacement gradients of the particles by the free displacement of their nodes, over alpha, row by row.
template <int D, class Connect>
struct StrainBlock
{
  Connect connect;
  Nodes<D> nodes;
  NodePositions<D> positions;
  View<double * [D * D]> strain;
  FreeDisplacement<D> free;

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    for (int p = begin; p < end; ++p)
      connect.visitStraining(p,
                             [&](int node, double, const typename Connect::Slopes& slopes)
                             {
                               const Vector<D> x = positions(latticeNode(nodes, node));
                               for (int i = 0; i < D; ++i)
                                 for (int j = 0; j < D; ++j)
                                   strain(p, i * D + j) += slopes(i, j) * free(x, i);
                             });
  }
};

template <int D>
View<double* [D * D]> strainOf(const State<D>& state, const FreeDisplacement<D>& free)
{
  const View<double * [D * D]> strain("strain", state.particles.size());
  withStraining(
      state,
      [&](const auto& connect)
      {
        using Connect = std::decay_t<decltype(connect)>;
        const StrainBlock<D, Connect> block{connect, state.mesh.nodes, nodePositions(state), strain, free};
        forEachBlock("strain", state.mesh.blocks, block);
      });
  return strain;
}

/// Gives nodes the change of temperature T0 + g . x.
template <int D>
thermal::HeatNodes<D> changeOf(const State<D>& state, const FreeDisplacement<D>& free)
{
  thermal::HeatNodes<D> heat;
  heat.clear(state);
  const auto value = Kokkos::create_mirror_view(heat.value);
  const NodePositions<D> positions = nodePositions(state);
  for (int i = 0; i < state.mesh.nodes.numActive(); ++i)
  {
    const int n = activeNode(state.mesh.nodes, i);
    value(n, 1) = free.temperature(positions(latticeNode(state.mesh.nodes, n)));
  }
  Kokkos::deep_copy(heat.value, value);
  return heat;
}

/// Corrects for the change of the particles' gradients by that of the nodes' temperatures.
template <int D>
void correctFor(State<D>& state, const thermal::HeatNodes<D>& heat)
{
  const auto gradient = state.particles.template real<D>(fields::temperatureGradient);
  const View<double* [D]> before("before", state.particles.size());
  withConnectivity(state,
                   [&](const auto& connect)
                   {
                     for (int p = 0; p < state.particles.size(); ++p)
                     {
                       double change[D] = {};
                       connect.visit(p,
                                     [&](int node, double, const double* slope)
                                     {
                                       for (int d = 0; d < D; ++d)
                                         change[d] += slope[d] * heat.value(node, 1);
                                     });
                       for (int d = 0; d < D; ++d)
                       {
                         before(p, d) = gradient(p, d);
                         gradient(p, d) += change[d];
                       }
                     }
                   });
  thermal::correctExpansion(state, heat, before);
}

/// The strain of free nodes and the correction together are alpha T at every particle.
template <int D>
void expectFreeStrain(Teuchos::ParameterList scene, double factor, unsigned seed)
{
  std::mt19937 random(seed);
  Rhegma::Run<D> run(validated(scene));
  run.initialize();
  run.step(1e30, false); // cells, sides and stencils are known; nothing moves
  State<D>& state = run.state();
  const FreeDisplacement<D> free{0.0, randomVector<D>(random, -1.0, 1.0)};
  const auto strain = onHost(strainOf(state, free));
  correctFor(state, changeOf(state, free));
  const HostParticles<D> particles(state);
  double most = 0.0, corrected = 0.0;
  for (int p = 0; p < particles.size; ++p)
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
      {
        const double one = i == j ? 1.0 : 0.0, T = free.temperature(particles.at(p));
        const double correction = (particles.deformation(p, i * D + j) - one) / (factor * alpha);
        const double found = 0.5 * (strain(p, i * D + j) + strain(p, j * D + i));
        corrected = std::max(corrected, std::fabs(correction));
        most = std::max(most, std::fabs(found + correction - one * T));
      }
  EXPECT_GT(corrected, 0.05) << "seed " << seed;
  // Rounding of F = 1 over alpha, and the linear field over 20 cells.
  EXPECT_LT(most, 1e-8) << "seed " << seed;
}

template <int D>
void refine(Teuchos::ParameterList& scene, const Vector<D>& corner)
{
  Teuchos::ParameterList& adaptivity = scene.sublist("Adaptivity");
  adaptivity.set("Maximum Level", 2);
  Vector<D> upper = corner + all<D>(6.0);
  upper[0] = corner[0] + 2.5;
  adaptivity.sublist("Part").set("Lower Corner", array(corner));
  adaptivity.sublist("Part").set("Upper Corner", array(upper));
  adaptivity.sublist("Part").set("Level", 2);
}

} // namespace

TEST(CellExpansion, FreeNodesStrainParticlesByTheirTemperature)
{
  std::mt19937 random(3);
  for (unsigned seed = 0; seed < 12; ++seed)
  {
    const Vector<2> corner = randomVector<2>(random, 0.0, 1.0);
    const bool strain = seed % 3 == 0;
    Teuchos::ParameterList scene =
        body<2>(corner, seed % 2 == 0 ? "GIMP" : "Linear", strain ? "Strain" : "Stress", 0.3);
    scene.sublist("Bodies").sublist("Body").set("Rotation", 90.0 * corner[0]);
    if (seed % 4 >= 2)
      refine<2>(scene, corner);
    if (seed % 5 < 2)
      scene.sublist("Domain").set("Shear Strain", "At Cell Centres");
    if (seed >= 6)
    {
      const double y = 2.0 + 2.0 * corner[1], slope = corner[0] - 0.5;
      scene.sublist("Cracks").sublist("Cut").set(
          "Points",
          Teuchos::Array<double>(Teuchos::tuple(-4.0, y - 4.0 * slope, corner[0] + 3.0, y + slope * 3.0)));
    }
    expectFreeStrain<2>(scene, strain ? 1.3 : 1.0, seed);
  }
}

TEST(CellExpansion, FreeNodesStrainParticlesByTheirTemperature3D)
{
  std::mt19937 random(4);
  for (unsigned seed = 0; seed < 4; ++seed)
  {
    const Vector<3> corner = randomVector<3>(random, 0.0, 1.0);
    Teuchos::ParameterList scene = body<3>(corner, seed % 2 == 0 ? "GIMP" : "Linear", "", 0.3);
    if (seed == 1 || seed == 2)
      scene.sublist("Domain").set("Shear Strain", "At Cell Centres");
    if (seed >= 2)
      refine<3>(scene, corner);
    expectFreeStrain<3>(scene, 1.0, seed);
  }
}

namespace
{

template <int D>
std::string linearField(const Vector<D>& g)
{
  std::string text = std::to_string(start);
  const char* const axis[] = {"x", "y", "z"};
  for (int d = 0; d < D; ++d)
    text += " + (" + std::to_string(g[d]) + ") * " + axis[d];
  return text;
}

/// Largest component of stress that the particles have, over E alpha |g| h.
template <int D>
double largestStress(const State<D>& state, const Vector<D>& g)
{
  const HostParticles<D> particles(state);
  double most = 0.0;
  for (int p = 0; p < particles.size; ++p)
    for (int k = 0; k < symmetricSize<D>; ++k)
      if (D == 3 || k < 3) // in plane strain the stress across the plane stays
        most = std::max(most, std::fabs(particles.stress(p, k)));
  return most / (alpha * norm(g));
}

/// A free body in equilibrium under a linear temperature in any direction.
template <int D>
double stressOfFreeBody(const Vector<D>& corner, const Vector<D>& g, const std::string& shape,
                        const std::string& shear, const std::string& plane)
{
  Teuchos::ParameterList scene = body<D>(corner, shape, plane, 0.3);
  scene.sublist("Domain").set("Shear Strain", shear);
  scene.sublist("Time").set("Analysis", "Quasi-Static");
  scene.sublist("Time").set("Rigid Modes", "Remove");
  scene.sublist("Time").set("Final Time", 1.0);
  scene.sublist("Thermal").set("Conduction", "Implicit");
  scene.sublist("Bodies").sublist("Body").set("Temperature Field", linearField<D>(g));
  Rhegma::Run<D> run(validated(scene));
  run.initialize();
  while (run.state().clock.time < 1.0)
    run.step(1.0, false);
  return largestStress<D>(run.state(), g);
}

} // namespace

/// Nothing is left but squares of the strain, 600 alpha, times the 6 cells of the body, and what Newton's
/// method leaves.
TEST(CellExpansion, AFreeBodyHasNoStress)
{
  std::mt19937 random(5);
  for (const char* const shear : {"At Particles", "At Cell Centres"})
  {
    for (const char* const shape : {"Linear", "GIMP"})
      for (const char* const plane : {"Stress", "Strain"})
        EXPECT_LT(stressOfFreeBody<2>(all<2>(0.0), randomVector<2>(random, -1.0, 1.0), shape, shear, plane),
                  4e-4)
            << shape << plane << shear;
    EXPECT_LT(stressOfFreeBody<3>(all<3>(0.0), randomVector<3>(random, -1.0, 1.0), "GIMP", shear, ""), 4e-4);
  }
}

namespace
{

/// A free body whose particles have the strain of a linear temperature moves by two cells, into refined ones
/// where its particles are split. \return largest stress at the end, over E alpha |g| h
double stressAfterMotion(const Vector<2>& g, bool refined)
{
  Teuchos::ParameterList scene = body<2>(all<2>(0.0), "GIMP", "Stress", 0.3);
  Teuchos::ParameterList& moving = scene.sublist("Bodies").sublist("Body");
  moving.set("Temperature Field", linearField<2>(g));
  moving.set("Velocity", array(Vector<2>{{0.1, 0.07}}));
  if (refined)
    refine<2>(scene, Vector<2>{{6.6, 0.0}});
  Rhegma::Run<2> run(validated(scene));
  run.initialize();
  const HostParticles<2> particles(run.state());
  for (int p = 0; p < particles.size; ++p)
    for (int d = 0; d < 2; ++d)
      particles.deformation(p, 3 * d) += alpha * dot(g, particles.at(p));
  particles.store(run.state());
  thermal::startEnergy(run.state());
  while (run.state().clock.time < 20.0)
    run.step(20.0, false);
  EXPECT_EQ(run.state().particles.size() > particles.size, refined);
  return largestStress<2>(run.state(), g);
}

} // namespace

/// Temperature that moves with the body does not strain it, and parts of split particles have the stress of
/// the whole: none. Squares of the strain are 1e-6 of it, rounding of F is 1e-8 of it.
TEST(CellExpansion, AMovingBodyStaysFree)
{
  std::mt19937 random(6);
  EXPECT_LT(stressAfterMotion(randomVector<2>(random, -1.0, 1.0), false), 1e-5);
  EXPECT_LT(stressAfterMotion(randomVector<2>(random, -1.0, 1.0), true), 1e-5);
}

/// In cells full of particles the mean strain, and with it the mean thermal stress of a body that is held,
/// does not change; the strain of no particle changes by more than alpha g h / 4, with 2 x 2 in a cell.
TEST(CellExpansion, TheMeanOfACellStays)
{
  std::mt19937 random(7);
  for (const char* const shape : {"Linear", "GIMP"})
  {
    Rhegma::Run<2> run(validated(body<2>(all<2>(0.0), shape, "Stress", 0.3)));
    run.initialize();
    run.step(1e30, false);
    const Vector<2> g = randomVector<2>(random, -1.0, 1.0);
    correctFor(run.state(), changeOf(run.state(), FreeDisplacement<2>{5.0, g}));
    const HostParticles<2> particles(run.state());
    for (int d = 0; d < 2; ++d)
    {
      double sum = 0.0, most = 0.0;
      for (int p = 0; p < particles.size; ++p)
      {
        const double strain = (particles.deformation(p, 3 * d) - 1.0) / alpha;
        sum += strain;
        most = std::max(most, std::fabs(strain));
      }
      EXPECT_LT(std::fabs(sum) / particles.size, 1e-8);
      EXPECT_NEAR(most, 0.25 * std::fabs(g[d]), 1e-8);
    }
  }
}

/// On each side of a crack anywhere in the cells, particles are corrected by the gradient of that side:
/// -alpha g_i times the distance to the middle of the cell along axis i.
TEST(CellExpansion, SidesOfACrackDoNotMix)
{
  std::mt19937 random(8);
  for (int k = 0; k < 4; ++k)
  {
    const double height = 2.0 + 2.0 * randomVector<2>(random, 0.05, 0.45)[0];
    Teuchos::ParameterList scene = body<2>(all<2>(0.0), "Linear", "Stress", 0.3);
    scene.sublist("Cracks").sublist("Cut").set(
        "Points", Teuchos::Array<double>(Teuchos::tuple(-1.0, height, 7.0, height)));
    Rhegma::Run<2> run(validated(scene));
    run.initialize();
    run.step(1e30, false);
    const State<2>& state = run.state();
    const Vector<2> g = randomVector<2>(random, -1.0, 1.0);
    const thermal::HeatNodes<2> heat = changeOf(state, FreeDisplacement<2>{0.0, g});
    const auto value = onHost(heat.value);
    const auto side = onHost(state.cracks.nodeSide);
    const auto parent = onHost(state.mesh.nodes.parent);
    EXPECT_GT(state.mesh.nodes.numEnriched, 10);
    const auto negate = [&](int n) { value(n, 1) = -value(n, 1); };
    for (int n = 0; n < state.mesh.nodes.numLattice; ++n)
      if (state.mesh.grid.nodePosition(n)[1] < height)
        negate(n); // temperature -g . x below the crack
    for (int e = 0; e < state.mesh.nodes.numEnriched; ++e)
      if (side(parent(e)) > 0)
        negate(state.mesh.nodes.numLattice + e); // the material below, at a node above
    Kokkos::deep_copy(heat.value, value);
    correctFor(run.state(), heat);
    const HostParticles<2> particles(run.state());
    double most = 0.0;
    for (int p = 0; p < particles.size; ++p)
      for (int d = 0; d < 2; ++d)
      {
        const double x = particles.position(p, d), middle = std::floor(x) + 0.5;
        const double own = particles.position(p, 1) > height ? g[d] : -g[d];
        most =
            std::max(most, std::fabs((particles.deformation(p, 3 * d) - 1.0) / alpha + own * (middle - x)));
      }
    EXPECT_LT(most, 1e-8) << "crack at " << height;
  }
}

} // namespace Test
} // namespace Rhegma
