/// Extrapolated weights: linearly complete next to a crack, and with masses that are never negative.
#include "CrackedBeam.hpp"

#include <algorithm>
#include <cmath>

using namespace Rhegma;
using namespace Rhegma::cracks;
using namespace Rhegma::cracks::test;

namespace
{

/// Largest strain rate that a rigid rotation of 1 rad/s gives a particle next to the crack [1/s].
double rotationStrain(const State<2>& state)
{
  double largest = 0.0;
  for (const Seeing& one : stencilsNearCrack(state))
  {
    double gradient[2][2] = {};
    for (const Entry& entry : one.entries)
    {
      const int lattice = entry.node < state.mesh.nodes.numLattice
                              ? entry.node
                              : state.mesh.nodes.parent(entry.node - state.mesh.nodes.numLattice);
      const Vector<2> from = state.mesh.grid.nodePosition(lattice) - one.x;
      const double velocity[2] = {-from[1], from[0]};
      for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j)
          gradient[i][j] += velocity[i] * entry.slope[j];
    }
    largest = std::max({largest, std::fabs(gradient[0][0]), std::fabs(gradient[1][1]),
                        std::fabs(0.5 * (gradient[0][1] + gradient[1][0]))});
  }
  return largest;
}

/// Weights, slopes and first moments of a stencil: 1, 0, the particle's position, and the identity.
void expectLinearlyComplete(const State<2>& state, const Seeing& one)
{
  double weight = 0.0, moment[2] = {}, gradient[2][2] = {};
  for (const Entry& entry : one.entries)
  {
    const Vector<2> from = state.mesh.grid.nodePosition(entry.node) - one.x;
    weight += entry.weight;
    for (int i = 0; i < 2; ++i)
    {
      moment[i] += entry.weight * from[i];
      for (int j = 0; j < 2; ++j)
        gradient[i][j] += from[i] * entry.slope[j];
    }
  }
  // Up to 16 terms of at most 4 cells, 4 and 4 / cell, and positions rounded at 50 cells.
  constexpr double roundOff = 1e-13;
  EXPECT_NEAR(weight, 1.0, roundOff);
  for (int i = 0; i < 2; ++i)
  {
    EXPECT_NEAR(moment[i] / cell, 0.0, roundOff);
    for (int j = 0; j < 2; ++j)
      EXPECT_NEAR(gradient[i][j], i == j ? 1.0 : 0.0, roundOff);
  }
}

} // namespace

/// A cracked body that turns rigidly has no strain. The rounding of positions, 1e-17 m against cells of 2.5
/// mm, bounds the figure: 9 entries x 2 eps x 4.
TEST(CorrectedBrokenCell, TurnsRigidlyWithoutStrain)
{
  for (const std::string shape : {"Linear", "GIMP"})
    for (const std::string& points : {onRow, withinTolerance, midCell, inclined, steep})
    {
      const double largest = rotationStrain(beamAtRest("Corrected Broken Cell", shape, points)->state());
      std::printf("rotation strain of %s, crack at %s: %.1e\n", shape.c_str(), points.c_str(), largest);
      EXPECT_LT(largest, 5e-15) << shape << points;
    }
}

/// The same of eq. 3, for contrast: a half of the rotation rate is the bound, and it is nearly reached.
TEST(CorrectedBrokenCell, UnlikeEquationThree)
{
  const double linear = rotationStrain(beamAtRest("Broken Cell", "Linear", midCell)->state());
  EXPECT_GT(linear, 0.3);
  EXPECT_LE(linear, 0.5 + 1e-12);
}

TEST(CorrectedBrokenCell, IsLinearlyComplete)
{
  for (const std::string shape : {"Linear", "GIMP"})
    for (const std::string& points : {onRow, withinTolerance, midCell, inclined, steep})
    {
      const auto run = beamAtRest("Corrected Broken Cell", shape, points);
      const auto nodeSide = onHost(run->state().cracks.nodeSide);
      for (const Seeing& one : stencilsNearCrack(run->state()))
      {
        expectLinearlyComplete(run->state(), one);
        for (const Entry& entry : one.entries)
          EXPECT_FALSE(one.side != 0 && nodeSide(entry.node) == -one.side) << shape << points;
      }
    }
}

/// Inside of the body no node has less than half a cell's mass, and nothing is lost.
TEST(CorrectedBrokenCell, KeepsMassesOfHalfACell)
{
  for (const std::string& points : {onRow, midCell})
  {
    const auto run = beamAtRest("Corrected Broken Cell", "Linear", points);
    const State<2>& state = run->state();
    const std::vector<double> mass = nodalMasses(state);
    double sum = 0.0, least = 1e300;
    for (int n = 0; n < state.mesh.grid.numNodes; ++n)
    {
      sum += mass[n];
      const Vector<2> x = state.mesh.grid.nodePosition(n);
      if (mass[n] != 0.0 && x[0] > 0.5 * cell && x[0] < 0.1 - 0.5 * cell)
        least = std::min(least, mass[n]);
    }
    const double whole = 1200.0 * cell * cell * state.method.thickness;
    EXPECT_NEAR(sum, bodyMass(state), 1e-13 * bodyMass(state));
    EXPECT_GE(least, 0.5 * whole * (1.0 - 1e-12)) << points;
  }
}

/// At the boundary, where particles next to the crack touch a column of nodes that those further in do not
/// touch, extrapolation would take more mass from a node than it has.
TEST(CorrectedBrokenCell, HasNoNegativeMassAtTheRim)
{
  const auto run = beamAtRest("Corrected Broken Cell", "GIMP", midCell);
  State<2>& state = run->state();
  const auto position = state.particles.real<2>(fields::position);
  const auto host = onHost(position);
  for (const Seeing& one : stencilsNearCrack(state))
    if (one.side == -1 && one.x[0] < 0.5 * cell && one.x[1] > 0.01)
      host(one.particle, 0) -= 0.1 * cell;
  Kokkos::deep_copy(position, host);
  run->step(2e-15, false);
  const std::vector<double> mass = nodalMasses(state);
  int beyond = 0;
  for (int n = 0; n < state.mesh.grid.numNodes; ++n)
  {
    EXPECT_GE(mass[n], 0.0);
    beyond += mass[n] > 0.0 && state.mesh.grid.nodePosition(n)[0] < -0.5 * cell ? 1 : 0;
  }
  EXPECT_GT(beyond, 0);
}

/// Extrapolation feeds back more than is scattered, so the step is limited for any CFL.
TEST(CorrectedBrokenCell, LimitsTheStep)
{
  const auto run = beamAtRest("Corrected Broken Cell", "GIMP", onRow);
  const State<2>& state = run->state();
  EXPECT_NEAR(run->stableTimeStep(), 0.36 * cell / state.clock.fastestSpeed,
              1e-12 * cell / state.clock.fastestSpeed);
  const auto diagonal = beamAtRest("Corrected Broken Cell", "GIMP", "{0, 0.01, 0.04, 0.01, 0.046, 0.015}");
  EXPECT_NEAR(diagonal->stableTimeStep(), 0.18 * cell / diagonal->state().clock.fastestSpeed,
              1e-12 * cell / state.clock.fastestSpeed);
  const auto dual = beamAtRest("Dual Field", "GIMP", onRow);
  EXPECT_NEAR(dual->stableTimeStep(), 0.4 * cell / dual->state().clock.fastestSpeed,
              1e-12 * cell / state.clock.fastestSpeed);
}
