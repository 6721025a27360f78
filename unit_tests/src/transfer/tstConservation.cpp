/// Conservation in transfers between particles and nodes, for particles at any position.

#include "src/step/Bodies.hpp"
#include "step/CoreStep.hpp"
#include "transfer/Gather.hpp"
#include "transfer/Motion.hpp"
#include "transfer/Scatter.hpp"
#include "transfer/Stencils.hpp"
#include "transfer/Velocity.hpp"

#include <random>

namespace Rhegma
{
namespace Test
{

namespace
{

constexpr double roundOff = 1e-13; ///< of sums of some thousand numbers

/// A run of a box whose particles have been moved at random by up to half a cell, with random velocities and
/// stresses.
template <int D>
Run<D> shaken(const std::string& shape)
{
  const Vector<D> lower = all<D>(0.0), upper = all<D>(D == 2 ? 8.0 : 4.0);
  Teuchos::ParameterList scene = emptyScene<D>(lower - all<D>(4.0), upper + all<D>(4.0), 1.0, "MUSL", shape);
  addMaterial(scene, "Linear Elastic", 0.3);
  addBox<D>(scene, "Box", lower, upper);
  Run<D> run(validated(scene));
  run.initialize();
  HostParticles<D> particles(run.state());
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-0.5, 0.5);
  for (int p = 0; p < particles.size; ++p)
  {
    for (int d = 0; d < D; ++d)
    {
      particles.position(p, d) += number(random);
      particles.velocity(p, d) = number(random);
    }
    for (int k = 0; k < symmetricSize<D>; ++k)
      particles.stress(p, k) = number(random);
  }
  particles.store(run.state());
  sortState(run.state());
  storeStencils(run.state());
  clearNodes(run.state());
  return run;
}

/// Sums over the nodes in use of mass, momentum and force, and of their magnitudes.
template <int D>
struct NodeSums
{
  double mass = 0.0, momentum[D] = {}, force[D] = {}, sizeOfForce = 0.0;

  explicit NodeSums(const State<D>& state)
  {
    const auto sums = onHost(state.mesh.nodes.sums);
    for (int n = 0; n < state.mesh.nodes.numLattice; ++n)
    {
      mass += sums(n, Nodes<D>::massAt);
      for (int d = 0; d < D; ++d)
      {
        momentum[d] += sums(n, Nodes<D>::momentumAt + d);
        force[d] += sums(n, Nodes<D>::forceAt + d);
        sizeOfForce += std::fabs(sums(n, Nodes<D>::forceAt + d));
      }
    }
  }
};

template <int D>
void scatterKeepsSums(const std::string& shape)
{
  Run<D> run = shaken<D>(shape);
  scatter(run.state(), ScatterWhat::All);
  const HostParticles<D> particles(run.state());
  double mass = 0.0, momentum[D] = {}, size = 0.0;
  for (int p = 0; p < particles.size; ++p)
  {
    mass += particles.mass(p);
    for (int d = 0; d < D; ++d)
    {
      momentum[d] += particles.mass(p) * particles.velocity(p, d);
      size += particles.mass(p) * std::fabs(particles.velocity(p, d));
    }
  }
  const NodeSums<D> nodes(run.state());
  EXPECT_NEAR(nodes.mass, mass, roundOff * mass);
  EXPECT_GT(nodes.sizeOfForce, 0.1);
  for (int d = 0; d < D; ++d)
  {
    EXPECT_NEAR(nodes.momentum[d], momentum[d], roundOff * size);
    EXPECT_NEAR(nodes.force[d], 0.0, roundOff * nodes.sizeOfForce);
  }
}

/// Nodes that all have one velocity give it to every particle, whatever they had.
template <int D>
void gatherKeepsUniformMotion(const std::string& shape)
{
  Run<D> run = shaken<D>(shape);
  State<D>& state = run.state();
  state.clock.dt = 0.1;
  state.method.picFraction = 1.0;
  scatter(state, ScatterWhat::MassAndMomentum);
  const auto motion = Kokkos::create_mirror_view(state.mesh.nodes.motion);
  Kokkos::deep_copy(motion, 0.0);
  for (std::size_t n = 0; n < motion.extent(0); ++n)
    for (int d = 0; d < D; ++d)
      motion(n, d) = 1.0 + d;
  Kokkos::deep_copy(state.mesh.nodes.motion, motion);
  particleVelocity(state, VelocityWhat::Gather);
  const HostParticles<D> particles(state);
  for (int p = 0; p < particles.size; ++p)
    for (int d = 0; d < D; ++d)
      ASSERT_NEAR(particles.velocity(p, d), 1.0 + d, roundOff) << "particle " << p;
}

/// Projected and gathered again, momentum is that of the particles.
template <int D>
void projectionKeepsMomentum(const std::string& shape)
{
  Run<D> run = shaken<D>(shape);
  State<D>& state = run.state();
  scatter(state, ScatterWhat::MassAndMomentum);
  particleVelocity(state, VelocityWhat::Project);
  const auto projection = onHost(state.mesh.nodes.projection);
  const NodeSums<D> nodes(state);
  for (int d = 0; d < D; ++d)
  {
    double total = 0.0, size = 0.0;
    for (int n = 0; n < state.mesh.nodes.numLattice; ++n)
    {
      total += projection(n, d);
      size += std::fabs(projection(n, d));
    }
    EXPECT_NEAR(total, nodes.momentum[d], roundOff * size);
  }
}

} // namespace

TEST(Conservation, ScatterIn2D)
{
  for (const char* shape : {"Linear", "GIMP"})
    scatterKeepsSums<2>(shape);
}

TEST(Conservation, ScatterIn3D)
{
  for (const char* shape : {"Linear", "GIMP"})
    scatterKeepsSums<3>(shape);
}

TEST(Conservation, GatherIn2D)
{
  for (const char* shape : {"Linear", "GIMP"})
    gatherKeepsUniformMotion<2>(shape);
}

TEST(Conservation, GatherIn3D)
{
  for (const char* shape : {"Linear", "GIMP"})
    gatherKeepsUniformMotion<3>(shape);
}

TEST(Conservation, ProjectionIn2D)
{
  for (const char* shape : {"Linear", "GIMP"})
    projectionKeepsMomentum<2>(shape);
}

TEST(Conservation, ProjectionIn3D) { projectionKeepsMomentum<3>("GIMP"); }

} // namespace Test
} // namespace Rhegma
