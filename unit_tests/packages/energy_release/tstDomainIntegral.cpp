#include "LatticeState.hpp"

#include "energy_release/DomainIntegral.hpp"
#include "energy_release/InternalAcceleration.hpp"

#include <gtest/gtest.h>

using namespace Rhegma;
using namespace Rhegma::energy_release;
using namespace Rhegma::energy_release::test;

namespace
{

constexpr double half = 0.01;
const ContourRadii radii{3e-3, 7e-3};

double effectiveModulus(Plane plane)
{
  return plane == Plane::Stress ? young : young / (1.0 - poisson * poisson);
}

/// Quadrature: the integrand falls as 1/r, so that the midpoint rule on particles of half a cell is off by
/// (cell / 2)^2 / 24 times 2/r^2 in each direction, at most (cell / inner)^2 / 24 where the ring begins.
double quadrature(double cell) { return cell * cell / (24.0 * radii.inner * radii.inner); }

/// Strains are 1e-8 where the ring begins: rotations and stretch matter no more than that.
constexpr double smallK = 1.0;

void checkTipField(Plane plane, ShapeKind shape, double angle, double modeI, double modeII, double cell)
{
  State<2> state = makeBody(half, cell, plane, shape, {{0.3, -0.2}});
  const CrackFront<2> front = addFront(state, {{0.13e-3, 0.07e-3}}, angle);
  deform(state, tipDisplacement(state, front, modeI, modeII));
  const DomainIntegral result = integrateDomain(state, front, radii, nodalAcceleration(state));
  const double K = std::sqrt(modeI * modeI + modeII * modeII), G = K * K / effectiveModulus(plane);
  const double tolerance = quadrature(cell) + 1e-7;
  EXPECT_NEAR(result.J, G, tolerance * G);
  EXPECT_NEAR(result.modeI, modeI, tolerance * K);
  EXPECT_NEAR(result.modeII, modeII, tolerance * K);
}

/// A finite turn of what a field deforms.
DisplacementField turned(const DisplacementField& field, double angle)
{
  return [=](const Vector<2>& x)
  {
    const Displacement d = field(x);
    const double R[4] = {std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle)};
    const double F[4] = {1.0 + d.gradient[0], d.gradient[1], d.gradient[2], 1.0 + d.gradient[3]};
    const Vector<2> moved = x + d.u;
    Displacement t;
    for (int i = 0; i < 2; ++i)
    {
      t.u[i] = R[2 * i] * moved[0] + R[2 * i + 1] * moved[1] - x[i];
      for (int j = 0; j < 2; ++j)
        t.gradient[2 * i + j] = R[2 * i] * F[j] + R[2 * i + 1] * F[2 + j] - (i == j ? 1.0 : 0.0);
    }
    return t;
  };
}

/// Plane dilatational waves along x: u = A [s sin(k x - w t) + (1 - s) sin(k x) cos(w t)] at k x0 = 0; a
/// travelling one (s = 1) or a standing one (s = 0), in a body without a crack: nothing is released, J = 0.
double waveIntegral(double cell, double travelling, double direction, double& scale)
{
  State<2> state = makeBody(half, cell, Plane::Strain, ShapeKind::Linear);
  const double speed = std::sqrt(elasticity(state.materials.properties[0]).constrainedModulus / density);
  const double k = 250.0, w = k * speed, amplitude = 1e-10, phase = 0.7;
  deform(state,
         [=](const Vector<2>& x)
         {
           const double a = k * x[0] - phase, s = travelling, o = 1.0 - travelling;
           Displacement d{{{0.0, 0.0}}, {0.0, 0.0, 0.0, 0.0}};
           d.u[0] = amplitude * (s * std::sin(a) + o * std::sin(k * x[0]) * std::cos(phase));
           d.gradient[0] = amplitude * k * (s * std::cos(a) + o * std::cos(k * x[0]) * std::cos(phase));
           return d;
         });
  setMotion(state,
            [=](const Vector<2>& x)
            {
              const double a = k * x[0] - phase, s = travelling, o = 1.0 - travelling;
              Motion m{{{0.0, 0.0}}, {{0.0, 0.0}}};
              m.velocity[0] = -amplitude * w * (s * std::cos(a) + o * std::sin(k * x[0]) * std::sin(phase));
              m.acceleration[0] =
                  -amplitude * w * w * (s * std::sin(a) + o * std::sin(k * x[0]) * std::cos(phase));
              return m;
            });
  const CrackFront<2> front = addFront(state, {{1.1e-3, 0.4e-3}}, direction);
  // The largest sum of strain and kinetic energy, across the disk.
  scale = density * amplitude * amplitude * w * w * 2.0 * radii.outer;
  return integrateDomain(state, front, radii, nodalAcceleration(state)).J;
}

/// Linear interpolation of nodal motion is off by (k cell)^2 / 8, its gradient and the particles' quadrature
/// by as much.
void expectNoRelease(double travelling, double direction)
{
  const double cell = 0.5e-3, error = 250.0 * cell * 250.0 * cell / 8.0;
  double scale = 0.0;
  const double J = waveIntegral(cell, travelling, direction, scale);
  EXPECT_NEAR(J, 0.0, error * scale);
}

} // namespace

TEST(DomainIntegral, FindsOpeningAlongTheGrid)
{
  checkTipField(Plane::Strain, ShapeKind::Gimp, 0.0, smallK, 0.0, 1e-3);
}
TEST(DomainIntegral, FindsSlidingAlongTheGrid)
{
  checkTipField(Plane::Strain, ShapeKind::Linear, 0.0, 0.0, smallK, 1e-3);
}
TEST(DomainIntegral, FindsBothModesInATurnedFrame)
{
  checkTipField(Plane::Strain, ShapeKind::Gimp, std::acos(-1.0) / 6.0, smallK, 0.5 * smallK, 1e-3);
}
TEST(DomainIntegral, FindsBothModesInPlaneStressBackwards)
{
  checkTipField(Plane::Stress, ShapeKind::Linear, 2.4, smallK, -0.7 * smallK, 1e-3);
}

/// The field of a tip 0.4 mm ahead of the front or behind it is found where it is. Reciprocity weighs terms
/// of the size of outer radius by the quadrature's error.
TEST(DomainIntegral, FindsTheTipThatTheCellsHave)
{
  const double cell = 1e-3;
  for (const double offset : {0.4e-3, -0.4e-3})
  {
    State<2> state = makeBody(half, cell, Plane::Strain, ShapeKind::Gimp, {{0.3, -0.2}});
    const double angle = 0.4;
    CrackFront<2> front = addFront(state, {{0.13e-3, 0.07e-3}}, angle);
    CrackFront<2> tip = front;
    tip.position = tip.position + offset * front.direction;
    deform(state, tipDisplacement(state, tip, smallK, -0.5 * smallK));
    const DomainIntegral result = integrateDomain(state, front, radii, nodalAcceleration(state));
    EXPECT_NEAR(result.tipOffset, offset, quadrature(cell) * radii.outer + 1e-3 * cell);
    EXPECT_NEAR(result.modeI, smallK, quadrature(cell));
    EXPECT_NEAR(result.modeII, -0.5 * smallK, quadrature(cell));
  }
}

TEST(DomainIntegral, IsCloserOnFinerCells)
{
  for (const double cell : {0.5e-3, 0.25e-3})
    checkTipField(Plane::Strain, ShapeKind::Gimp, 0.4, smallK, 0.3 * smallK, cell);
}

TEST(DomainIntegral, IsZeroForAFiniteTurn)
{
  State<2> state = makeBody(half, 1e-3, Plane::Strain, ShapeKind::Gimp);
  const CrackFront<2> front = addFront(state, {{0.0, 0.0}}, 0.3);
  deform(state, turned(
                    [](const Vector<2>&) {
                      return Displacement{{{0.0, 0.0}}, {0.0, 0.0, 0.0, 0.0}};
                    },
                    0.8));
  const DomainIntegral result = integrateDomain(state, front, radii, nodalAcceleration(state));
  // Strains of round-off, e = 4e-16: J is of the order E e^2 times the radius, K of E e times its root.
  EXPECT_NEAR(result.J, 0.0, 10.0 * young * 1.6e-31 * radii.outer);
  EXPECT_NEAR(result.modeI, 0.0, 10.0 * young * 4e-16 * std::sqrt(radii.outer));
  EXPECT_NEAR(result.modeII, 0.0, 10.0 * young * 4e-16 * std::sqrt(radii.outer));
}

TEST(DomainIntegral, IsTheSameForATurnedBody)
{
  const double angle = 0.8, cell = 0.5e-3;
  State<2> state = makeBody(half, cell, Plane::Strain, ShapeKind::Gimp);
  CrackFront<2> front = addFront(state, {{0.0, 0.0}}, 0.0);
  deform(state, turned(tipDisplacement(state, front, smallK, 0.4 * smallK), angle));
  front = addFront(state, {{0.0, 0.0}}, angle);
  const DomainIntegral result = integrateDomain(state, front, radii, nodalAcceleration(state));
  // A turned lattice samples the weight's slope, which jumps between cells, at worst like points at random:
  // off by one over the root of their number.
  const double ring = std::acos(-1.0) * (radii.outer * radii.outer - radii.inner * radii.inner);
  const double tolerance = 0.5 * cell / std::sqrt(ring);
  EXPECT_NEAR(result.J, 1.16 / effectiveModulus(Plane::Strain),
              tolerance * 1.16 / effectiveModulus(Plane::Strain));
  EXPECT_NEAR(result.modeI, smallK, tolerance);
  EXPECT_NEAR(result.modeII, 0.4 * smallK, tolerance);
}

/// Linear interpolation of nodal motion is off by (k cell)^2 / 8, its gradient and the particles' quadrature
/// by as much.
TEST(DomainIntegral, IsZeroInATravellingWave)
{
  expectNoRelease(1.0, 0.0);
  expectNoRelease(1.0, 0.6);
}

TEST(DomainIntegral, IsZeroInAStandingWave)
{
  expectNoRelease(0.0, 0.0);
  expectNoRelease(0.5, 0.6);
}

/// A field that moves steadily along the crack, u(x - c t): rho a u,1 and rho v v,1 cancel at any speed,
/// which leaves (P_11 u_1,1 - W - T) q,1 = (M - rho c^2) (u_1,1)^2 / 2 q,1, found here by an independent fine
/// quadrature. Between wave speeds such a field is not in equilibrium, so that the integral is not zero.
TEST(DomainIntegral, InertiaCancelsInSteadyMotion)
{
  const double cell = 0.25e-3, k = 300.0, speed = 500.0, amplitude = 1e-9;
  State<2> state = makeBody(half, cell, Plane::Strain, ShapeKind::Linear);
  deform(state,
         [=](const Vector<2>& x)
         {
           Displacement d{{{0.0, 0.0}}, {0.0, 0.0, 0.0, 0.0}};
           d.u[0] = amplitude * std::sin(k * x[0]);
           d.gradient[0] = amplitude * k * std::cos(k * x[0]);
           return d;
         });
  setMotion(state,
            [=](const Vector<2>& x)
            {
              Motion m{{{0.0, 0.0}}, {{0.0, 0.0}}};
              m.velocity[0] = -speed * amplitude * k * std::cos(k * x[0]);
              m.acceleration[0] = -speed * speed * amplitude * k * k * std::sin(k * x[0]);
              return m;
            });
  const CrackFront<2> front = addFront(state, {{1.0e-3, 0.0}}, 0.0);
  const double modulus = elasticity(state.materials.properties[0]).constrainedModulus;
  double expected = 0.0;
  const int n = 2000;
  const double step = 2.0 * radii.outer / n;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
    {
      const double x = -radii.outer + (i + 0.5) * step, y = -radii.outer + (j + 0.5) * step;
      const double r = std::sqrt(x * x + y * y);
      if (r < radii.inner || r > radii.outer)
        continue;
      const double slope = amplitude * k * std::cos(k * (x + front.position[0]));
      expected -= 0.5 * (modulus - density * speed * speed) * slope * slope * x / r /
                  (radii.outer - radii.inner) * step * step;
    }
  const double error = k * cell * k * cell / 8.0;
  const double scale =
      0.5 * (modulus + density * speed * speed) * amplitude * amplitude * k * k * 2.0 * radii.outer;
  EXPECT_NEAR(integrateDomain(state, front, radii, nodalAcceleration(state)).J, expected, error * scale);
  EXPECT_GT(std::fabs(expected), 10.0 * error * scale);
}

/// u = s x^2 / (2 M) along x has div stress = s = 1e6 N/m^3 everywhere: a body held by a body force of -s.
/// Nothing is released, and J knows of the force by the acceleration that the stress alone would give.
TEST(DomainIntegral, KnowsOfLoadsInsideTheDisk)
{
  const double cell = 0.5e-3, slope = 1e6;
  State<2> state = makeBody(half, cell, Plane::Strain, ShapeKind::Linear);
  const double modulus = elasticity(state.materials.properties[0]).constrainedModulus;
  deform(state,
         [=](const Vector<2>& x)
         {
           Displacement d{{{0.0, 0.0}}, {0.0, 0.0, 0.0, 0.0}};
           d.u[0] = 0.5 * slope * x[0] * x[0] / modulus;
           d.gradient[0] = slope * x[0] / modulus;
           return d;
         });
  state.mesh.blocks.first = View<int*>("rhegma::blockFirst", 2);
  state.mesh.blocks.first(1) = state.particles.size();
  for (int c = 1; c <= Blocks<2>::colours; ++c)
    state.mesh.blocks.colourStart[c] = 1;
  for (int n = 0; n < state.mesh.grid.numNodes; ++n)
    state.mesh.nodes.sums(n, Nodes<2>::massAt) = density * cell * cell * thickness;

  const CrackFront<2> front = addFront(state, {{1.0e-3, 0.0}}, 0.0);
  InternalAcceleration<2> internal;
  const NodalAcceleration<2> acceleration = internal.around(state, {front.position, half});
  int cells[2] = {static_cast<int>(state.mesh.grid.inCells(1e-3, 0)),
                  static_cast<int>(state.mesh.grid.inCells(0.0, 1))};
  const int middle = state.mesh.grid.nodeIndex(cells);
  // Central differences are exact for a linear stress; strains of 2e-6 change it by as much.
  EXPECT_NEAR(acceleration(middle, 0), slope / density, 1e-4 * slope / density);
  EXPECT_NEAR(acceleration(middle, 1), 0.0, 1e-4 * slope / density);

  const NodalAcceleration<2> none("rhegma::none", state.mesh.grid.numNodes);
  const double unaware = integrateDomain(state, front, radii, none).J;
  EXPECT_NEAR(integrateDomain(state, front, radii, internal).J, 0.0, quadrature(cell) * std::fabs(unaware));
}

/// A disk that the body has left has no J.
TEST(DomainIntegral, HasNoReleaseWithoutMaterial)
{
  State<2> state = makeBody(half, 0.5e-3, Plane::Strain, ShapeKind::Linear);
  const CrackFront<2> front = addFront(state, {{1.0e-3, 0.0}}, 0.0);
  const NodalAcceleration<2> none("rhegma::none", state.mesh.grid.numNodes);
  EXPECT_EQ(integrateRelease(state, front, radii, none), 0.0); // at rest, without stress
  EXPECT_FALSE(integrateDomain(state, front, radii, none).lost);
  const auto position = state.particles.real<2>(fields::position);
  for (int p = 0; p < state.particles.size(); ++p)
    position(p, 0) += 10.0 * half;
  EXPECT_FALSE(integrateRelease(state, front, radii, none).has_value());
  EXPECT_TRUE(integrateDomain(state, front, radii, none).lost);
}
