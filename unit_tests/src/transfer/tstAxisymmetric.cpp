/// Transfers between particles that are rings and nodes that are circles.

#include "Seed.hpp"
#include "src/step/Bodies.hpp"
#include "step/CoreStep.hpp"
#include "transfer/Gather.hpp"
#include "transfer/Motion.hpp"
#include "transfer/Scatter.hpp"
#include "transfer/Stencils.hpp"

#include <cmath>
#include <random>

namespace Rhegma
{
namespace Test
{

namespace
{

constexpr double roundOff = 1e-12; ///< of sums of a few hundred numbers

/// Averages over a box with weight r, of a node's hat function and of its slope: by two points in each cell
/// that the box touches, which are exact for the products of two linear functions.
void averages(double at, double half, double radius, int node, double& weight, double& slope)
{
  weight = slope = 0.0;
  const int first = static_cast<int>(at - half);
  for (int cell = first; cell < first + 2; ++cell)
  {
    const double begin = std::max(at - half, double(cell)), end = std::min(at + half, cell + 1.0);
    for (const double sign : {-1.0, 1.0})
    {
      const double x = 0.5 * (begin + end) + sign * (end - begin) / std::sqrt(12.0);
      const double part = std::max(0.0, 0.5 * (end - begin)) * (radius + x - at) / (2.0 * half * radius);
      weight += part * std::max(0.0, 1.0 - std::fabs(x - node));
      slope += part * (cell == node ? -1.0 : cell + 1 == node ? 1.0 : 0.0);
    }
  }
}

/// A ring or a full cylinder of 8 by 8 cells, anywhere in the cells along the axis.
Run<2> cylinder(const std::string& shape, double inner, const std::string& formulation = "Updated Lagrangian")
{
  std::mt19937 random(seed());
  std::uniform_real_distribution<double> fraction(0.0, 1.0);
  const double below = fraction(random);
  Teuchos::ParameterList scene = emptyScene<2>({0.0, -4.0}, {inner + 12.0, 14.0}, 1.0, "MUSL", shape);
  scene.sublist("Domain").set("Plane", "Axisymmetric");
  scene.sublist("Domain").set("Formulation", formulation);
  addMaterial(scene, "Linear Elastic", 0.3);
  addBox<2>(scene, "Box", {inner, below}, {inner + 8.0, below + 8.0});
  Run<2> run(validated(scene));
  run.initialize();
  sortState(run.state());
  storeStencils(run.state());
  clearNodes(run.state());
  return run;
}

/// Sets a velocity of all nodes, linear in the radius.
void expand(State<2>& state, double rate)
{
  const auto projection = Kokkos::create_mirror_view(state.mesh.nodes.projection);
  for (int n = 0; n < state.mesh.nodes.numLattice; ++n)
  {
    projection(n, 0) = rate * state.mesh.grid.nodePosition(n)[0];
    projection(n, 1) = 0.0;
  }
  Kokkos::deep_copy(state.mesh.nodes.projection, projection);
}

} // namespace

TEST(Axisymmetric, WeightsAreAveragesOverRings)
{
  std::mt19937 random(seed());
  std::uniform_real_distribution<double> number(0.0, 1.0);
  for (int k = 0; k < 100; ++k)
  {
    const double half = 0.5 * (0.1 + 0.9 * number(random)), at = 3.0 + number(random);
    const double radius = half * (1.0 + 10.0 * number(random) * number(random));
    const AxisStencil<3> s = weightedByRadius(gimpStencil(at, half), at, half, radius);
    for (int i = 0; i < 3; ++i)
    {
      double weight, slope;
      averages(at, half, radius, s.first + i, weight, slope);
      EXPECT_NEAR(s.weight[i], weight, roundOff) << at << ' ' << half << ' ' << radius;
      EXPECT_NEAR(s.slope[i], slope, roundOff) << at << ' ' << half << ' ' << radius;
    }
  }
}

/// Rings have the volume of the body of revolution, and nodes have all of their mass.
TEST(Axisymmetric, Mass)
{
  const double pi = std::acos(-1.0);
  for (const char* shape : {"Linear", "GIMP"})
    for (const double inner : {0.0, 3.3})
    {
      auto run = cylinder(shape, inner);
      scatter(run.state(), ScatterWhat::MassAndMomentum);
      const HostParticles<2> particles(run.state());
      const auto sums = onHost(run.state().mesh.nodes.sums);
      const auto volume = onHost(run.state().particles.scalar(fields::volume));
      double mass = 0.0, ofNodes = 0.0, all = 0.0;
      for (int p = 0; p < particles.size; ++p)
      {
        mass += particles.mass(p);
        all += volume(p);
      }
      for (int n = 0; n < run.state().mesh.nodes.numLattice; ++n)
        ofNodes += sums(n, Nodes<2>::massAt);
      const double exact = pi * (std::pow(inner + 8.0, 2) - inner * inner) * 8.0;
      EXPECT_NEAR(all, exact, roundOff * exact);
      EXPECT_NEAR(ofNodes, mass, roundOff * mass);
    }
}

/// The same stress in all directions is in equilibrium: no force on nodes inside of the body, nor on the
/// axis.
TEST(Axisymmetric, UniformPressureExertsNoForceInside)
{
  for (const double inner : {0.0, 2.7})
  {
    auto run = cylinder("GIMP", inner);
    State<2>& state = run.state();
    HostParticles<2> particles(state);
    double low = 1e300, high = -1e300;
    for (int p = 0; p < particles.size; ++p)
    {
      for (const int k : {0, 1, 3})
        particles.stress(p, k) = 1.0;
      low = std::min(low, particles.position(p, 1));
      high = std::max(high, particles.position(p, 1));
    }
    particles.store(state);
    scatter(state, ScatterWhat::Force);
    const auto sums = onHost(state.mesh.nodes.sums);
    int inside = 0;
    for (int n = 0; n < state.mesh.nodes.numLattice; ++n)
    {
      const Vector<2> x = state.mesh.grid.nodePosition(n);
      const bool away = (inner == 0.0 || x[0] > inner + 1.0) && x[0] >= 0.0 && x[0] < inner + 7.0 &&
                        x[1] > low + 1.3 && x[1] < high - 1.3;
      for (int d = 0; d < 2 && away; ++d)
        EXPECT_NEAR(sums(n, Nodes<2>::forceAt + d), 0.0, roundOff * (1.0 + x[0])) << x[0] << ' ' << x[1];
      inside += away ? 1 : 0;
    }
    EXPECT_GT(inside, 20);
  }
}

/// A velocity that is proportional to the radius strains radius and hoop alike, and moves particles with it,
/// those next to the axis too.
TEST(Axisymmetric, Expansion)
{
  for (const char* formulation : {"Updated Lagrangian", "Total Lagrangian"})
    for (const char* shape : {"Linear", "GIMP"})
    {
      auto run = cylinder(shape, 0.0, formulation);
      State<2>& state = run.state();
      state.clock.dt = 1e-3;
      const HostParticles<2> before(state);
      expand(state, 0.2);
      strainAndMove(state, StrainVelocity::Projection, true, true);
      const HostParticles<2> after(state);
      const auto F = onHost(state.particles.real<gradientSize<2>>(fields::deformation));
      const bool moves = !state.method.totalLagrangian;
      for (int p = 0; p < after.size; ++p)
      {
        const double r = before.position(p, 0);
        EXPECT_NEAR(F(p, 0), 1.0002, roundOff);
        EXPECT_NEAR(F(p, 3), 1.0, roundOff);
        EXPECT_NEAR(F(p, 4), 1.0002, roundOff);
        EXPECT_NEAR(after.position(p, 0), (moves ? 1.0002 : 1.0) * r, roundOff * r);
      }
    }
}

} // namespace Test
} // namespace Rhegma
