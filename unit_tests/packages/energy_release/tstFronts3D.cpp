#include "../cracks/CubeScene.hpp"
#include "Pi.hpp"
#include "WilliamsField.hpp"

#include "energy_release/CrackTipFields.hpp"
#include "energy_release/DrivingForces.hpp"
#include "energy_release/FacePressureWork.hpp"
#include "energy_release/FrontIntegral.hpp"
#include "energy_release/FrontOpening.hpp"
#include "geometry/Cross.hpp"
#include "material/Materials.hpp"

#include <iostream>
#include <optional>

using namespace Rhegma;
using namespace Rhegma::cracks::test;
using namespace Rhegma::energy_release;

namespace
{

using Rhegma::Test::pi;
const double shear = young / (2.0 * (1.0 + poisson)), effective = young / (1.0 - poisson * poisson);
/// Strains are 1e-8 where the tube begins: rotations and stretch matter no more than that.
const Intensities smallK{1.0, 0.4, -0.7};
const FrontTube tube{{2e-3, 4e-3}, 2e-3};

/// A crack from the left, off the nodes, whose straight front runs along z through a block.
constexpr double tipX = 6.3e-3, tipY = 6.2e-3, depth = 8e-3;

std::unique_ptr<Run<3>> straightFront()
{
  Teuchos::ParameterList scene = blockScene({12e-3, 12e-3, depth});
  setCrack(scene, {0.0, tipY, depth, tipX, tipY, depth, tipX, tipY, 0.0, 0.0, tipY, 0.0});
  auto run = start<3>(scene);
  run->step(1e-9, true); // nothing moves yet
  return run;
}

/// Displacement and its gradient.
struct Displacement
{
  Vector<3> u{{0.0, 0.0, 0.0}};
  double gradient[3][3] = {};
};

/// Williams' field of the three modes about the front, in plane strain and antiplane shear.
Displacement tipField(const Intensities& K, const CrackFront<3>& front, const Vector<3>& x, int side)
{
  const Vector<3>&e = front.direction, &n = front.normal;
  const Vector<3> t{{e[1] * n[2] - e[2] * n[1], e[2] * n[0] - e[0] * n[2], e[0] * n[1] - e[1] * n[0]}};
  const Vector<3> from = x - front.position;
  const double along = dot(from, e), across = dot(from, n);
  const double r = std::sqrt(along * along + across * across);
  double theta = std::atan2(across, along);
  if (side * theta < -0.75 * pi) // on the other face
    theta += 2.0 * side * pi;
  const TipModuli moduli{shear, 3.0 - 4.0 * poisson};
  const TipField one = williamsField(0, r, theta, moduli), two = williamsField(1, r, theta, moduli);
  const double size = 2.0 * K.modeIII / shear * std::sqrt(r / (2.0 * pi));
  // w = size sin(theta / 2)
  const double slope[2] = {-0.5 * size / r * std::sin(0.5 * theta), 0.5 * size / r * std::cos(0.5 * theta)};
  const Vector<3> axis[3] = {e, n, t};
  double own[3][3] = {}, u[3] = {0.0, 0.0, size * std::sin(0.5 * theta)};
  for (int i = 0; i < 2; ++i)
  {
    u[i] = K.modeI * one.displacement[i] + K.modeII * two.displacement[i];
    own[2][i] = slope[i];
    for (int j = 0; j < 2; ++j)
      own[i][j] = K.modeI * one.gradient[i][j] + K.modeII * two.gradient[i][j];
  }
  Displacement d;
  for (int a = 0; a < 3; ++a)
  {
    d.u = d.u + u[a] * axis[a];
    for (int b = 0; b < 3; ++b)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          d.gradient[i][j] += own[a][b] * axis[a][i] * axis[b][j];
  }
  return d;
}

/// Puts the particles where a field says, with the stress of their law.
template <class Field>
void deform(State<3>& state, const Field& field)
{
  const auto reference = state.particles.real<3>(fields::reference);
  const auto position = state.particles.real<3>(fields::position);
  const auto F = state.particles.real<gradientSize<3>>(fields::deformation);
  const auto stress = state.particles.real<symmetricSize<3>>(fields::stress);
  const auto side = state.particles.integer(fields::side);
  for (int p = 0; p < state.particles.size(); ++p)
  {
    const Displacement d = field(Vector<3>{reference(p, 0), reference(p, 1), reference(p, 2)}, side(p));
    for (int i = 0; i < 3; ++i)
    {
      position(p, i) = reference(p, i) + d.u[i];
      for (int j = 0; j < 3; ++j)
        F(p, 3 * i + j) = d.gradient[i][j] + (i == j ? 1.0 : 0.0);
    }
    updateStress<3>(state.materials.properties[0], &F(p, 0), &stress(p, 0), nullptr);
  }
}

NodalAcceleration<3> noAcceleration(const State<3>& state)
{
  return NodalAcceleration<3>("rhegma::none", state.mesh.nodes.sums.extent(0));
}

/// The midpoint rule on particles of half a cell in an integrand that falls as 1 / r, where the ramp begins.
double quadrature() { return cell * cell / (24.0 * tube.radii.inner * tube.radii.inner); }

double exactRelease(const Intensities& K)
{
  return (K.modeI * K.modeI + K.modeII * K.modeII) / effective + K.modeIII * K.modeIII / (2.0 * shear);
}

/// J at every node of a front, which all have one.
std::vector<double> releaseOfAll(const State<3>& state, const CrackFront<3>& front,
                                 const NodalAcceleration<3>& acceleration)
{
  std::vector<double> all;
  for (const std::optional<double>& J : integrateWithAcceleration(state, lineOf(front), tube, acceleration))
    all.push_back(J.value());
  return all;
}

std::vector<double> releaseAlong(State<3>& state, const Intensities& K)
{
  const CrackFront<3> front = state.cracks.fronts.at(0);
  deform(state, [&](const Vector<3>& x, int side) { return tipField(K, front, x, side); });
  return releaseOfAll(state, front, noAcceleration(state));
}

/// Puts the faces of the crack where Williams has them.
void openFaces(State<3>& state, const Intensities& K)
{
  const CrackFront<3>& front = state.cracks.fronts.at(0);
  const auto face = state.cracks.face;
  const auto vertex = state.cracks.vertex;
  for (int v = 0; v < static_cast<int>(vertex.extent(0)); ++v)
    for (int side = 0; side < 2; ++side)
    {
      Vector<3> x{{vertex(v, 0), vertex(v, 1), vertex(v, 2)}};
      x = x + (side == 1 ? 1e-15 : -1e-15) * front.normal;
      const Displacement d = tipField(K, front, x, side == 1 ? 1 : -1);
      for (int i = 0; i < 3; ++i)
        face(v, side, i) = vertex(v, i) + d.u[i];
    }
}

/// Bends a straight front's crack into a cylinder whose axis is along the front. Openings turn by half as
/// much, as those of an arc of a circle do.
void bendFaces(State<3>& state, double radius)
{
  const CrackFront<3>& front = state.cracks.fronts.at(0);
  const auto face = state.cracks.face;
  const auto vertex = state.cracks.vertex, normal = state.cracks.normal;
  for (int v = 0; v < static_cast<int>(vertex.extent(0)); ++v)
  {
    const Vector<3> x{vertex(v, 0), vertex(v, 1), vertex(v, 2)};
    const double turn = -dot(x - front.position, front.direction) / radius, c = std::cos(0.5 * turn),
                 s = std::sin(0.5 * turn);
    const Vector<3> ahead = c * front.direction + s * front.normal;
    const Vector<3> across = c * front.normal - s * front.direction;
    const Vector<3> bent = x + radius * (turn - std::sin(turn)) * front.direction -
                           radius * (1.0 - std::cos(turn)) * front.normal;
    for (int side = 0; side < 2; ++side)
    {
      const Vector<3> u{face(v, side, 0) - x[0], face(v, side, 1) - x[1], face(v, side, 2) - x[2]};
      const double along = dot(u, front.direction), up = dot(u, front.normal);
      const Vector<3> turned = u + along * (ahead - front.direction) + up * (across - front.normal);
      for (int i = 0; i < 3; ++i)
        face(v, side, i) = bent[i] + turned[i];
    }
    for (int i = 0; i < 3; ++i)
      vertex(v, i) = bent[i];
  }
  const auto simplex = state.cracks.simplex;
  for (int t = 0; t < static_cast<int>(simplex.extent(0)); ++t)
  {
    const auto corner = [&](int i) {
      return Vector<3>{vertex(simplex(t, i), 0), vertex(simplex(t, i), 1), vertex(simplex(t, i), 2)};
    };
    Vector<3> n = cross(corner(1) - corner(0), corner(2) - corner(0));
    n = (dot(n, front.normal) > 0.0 ? 1.0 : -1.0) / norm(n) * n;
    for (int i = 0; i < 3; ++i)
      normal(t, i) = n[i];
  }
}

} // namespace

/// Every front node of a straight front, those at the surface included: no traction of the field does work
/// there on a shift along the crack.
TEST(Fronts3D, FindTheReleaseOfOpeningAndSliding)
{
  const auto run = straightFront();
  const Intensities K{smallK.modeI, smallK.modeII, 0.0};
  const std::vector<double> J = releaseAlong(run->state(), K);
  ASSERT_EQ(J.size(), 9u);
  for (const double j : J)
    EXPECT_NEAR(j, exactRelease(K), (quadrature() + 1e-7) * exactRelease(K));
}

/// Antiplane shear has a traction on the surface: only front nodes whose hat ends inside are its.
TEST(Fronts3D, FindTheReleaseOfAllModes)
{
  const auto run = straightFront();
  const FrontLine line = lineOf(run->state().cracks.fronts.at(0));
  const std::vector<double> J = releaseAlong(run->state(), smallK);
  int inside = 0;
  for (std::size_t k = 0; k < J.size(); ++k)
    if (line.arc[k] > tube.halfWidth + cell && line.arc[k] < depth - tube.halfWidth - cell)
    {
      ++inside;
      EXPECT_NEAR(J[k], exactRelease(smallK), (quadrature() + 1e-7) * exactRelease(smallK));
    }
  EXPECT_EQ(inside, 1);
}

/// The front node at the surface lies a quarter of a cell behind, so that its piece leans by atan(1/4) and
/// the next front node points half of that across the surface: the shift along the crack must not. That the
/// front is not quite where it is thought to be moves feet on it by up to 0.25 sin(atan(1/4)) = 0.06 of a
/// cell, where the hat of the front node is one cell wide in the mean. A shift through the surface makes 0.1
/// of J.
TEST(Fronts3D, ShiftNothingThroughTheSurfaceBehindAPieceThatLeans)
{
  const auto run = straightFront();
  State<3>& state = run->state();
  const Intensities K{1.0, 0.0, 0.0};
  const CrackFront<3> front = state.cracks.fronts.at(0);
  deform(state, [&](const Vector<3>& x, int side) { return tipField(K, front, x, side); });
  CrackFront<3> leaning = front;
  std::vector<FrontNode<3>>& s = leaning.nodes;
  s[0].position = s[0].position - 0.25 * cell * s[0].direction;
  const Vector<3> lean = s[1].position - s[0].position, along = s[2].position - s[1].position;
  ASSERT_NEAR(dot(along, front.direction), 0.0, 1e-9 * cell);
  // Across both pieces by their lengths.
  const Vector<3> mean = (norm(along) + dot(lean, along) / norm(along)) * front.direction -
                         (dot(lean, front.direction) / norm(along)) * along;
  s[1].direction = (1.0 / norm(mean)) * mean;
  const FrontLine line = lineOf(leaning);
  const FrontSight sight(line, 8.0 * cell);
  for (const double behind : {0.5, 1.0, 2.5})
  {
    const Vector<3> x = s[0].position - behind * cell * s[0].direction + 0.3 * cell * s[0].normal;
    EXPECT_NEAR(dot(sight.locate(x).direction, s[0].direction), 1.0, 1e-12) << behind;
  }
  const double J = releaseOfAll(state, leaning, noAcceleration(state)).front();
  std::cout << "J at the end of a front whose last piece leans, over the exact one: " << J / exactRelease(K)
            << "\n";
  EXPECT_NEAR(J, exactRelease(K), 0.25 * std::sin(std::atan(0.25)) * exactRelease(K));
}

/// What a pressure releases where the faces open as Williams has it: int p [u_n] dr over the ramp, as q falls
/// there. The cells cut the ramp's corners by a quarter of their edge times its slope, within which the
/// opening changes by its slope: h^2 / (8 r) of it over a ramp as long as r, at both corners at most. The
/// nodes' displacement is of second order, and so is the opening between them: together h^2 / (16 r^2) of it.
TEST(Fronts3D, FindTheReleaseByAPressure)
{
  const auto run = straightFront();
  State<3>& state = run->state();
  const CrackFront<3> front = state.cracks.fronts.at(0);
  const Intensities K{1.0, 0.0, 0.0};
  const double pressure = 3.0;
  deform(state, [&](const Vector<3>& x, int side) { return tipField(K, front, x, side); });
  state.clock.step = 1;
  state.cracks.pressure = View<double*>("pressure", state.cracks.simplex.extent(0));
  Kokkos::deep_copy(state.cracks.pressure, pressure);
  for (const ContourRadii& radii : {ContourRadii{2e-3, 4e-3}, ContourRadii{1.5e-3, 4.5e-3}})
  {
    const ConfigurationalForces force("force", state.mesh.nodes.sums.extent(0));
    addForceOfPressure(state, front.crack, lineOf(front), {radii, 2e-3}, force);
    double release = 0.0;
    for (int n = 0; n < state.mesh.grid.numNodes; ++n)
    {
      const Vector<3> from = state.mesh.grid.nodePosition(n) - front.position;
      const double r = std::hypot(dot(from, front.direction), dot(from, front.normal));
      const double ramp = std::clamp((radii.outer - r) / (radii.outer - radii.inner), 0.0, 1.0);
      for (int d = 0; d < 3; ++d)
        release += ramp * front.direction[d] * force(n, d) / depth;
    }
    // [u_n] = 8 K / E' sqrt(r / 2 pi)
    const double exact = pressure * 8.0 * K.modeI / effective / std::sqrt(2.0 * pi) * 2.0 / 3.0 *
                         (std::pow(radii.outer, 1.5) - std::pow(radii.inner, 1.5)) /
                         (radii.outer - radii.inner);
    const double corners = cell * cell / (4.0 * radii.inner * (radii.outer - radii.inner));
    EXPECT_NEAR(release, exact, exact * (corners + cell * cell / (16.0 * radii.inner * radii.inner)));
  }
}

/// A plane wave in a body whose crack it does not feel releases nothing, if both terms of inertia are there.
TEST(Fronts3D, FindNothingInAWave)
{
  const auto run = straightFront();
  State<3>& state = run->state();
  const double k = 250.0, amplitude = 1e-10, phase = 0.7;
  const double speed = std::sqrt(elasticity(state.materials.properties[0]).constrainedModulus / density);
  deform(state,
         [&](const Vector<3>& x, int)
         {
           Displacement d;
           d.u[0] = amplitude * std::sin(k * x[0] - phase);
           d.gradient[0][0] = amplitude * k * std::cos(k * x[0] - phase);
           return d;
         });
  const auto motion = state.mesh.nodes.projection;
  NodalAcceleration<3> acceleration = noAcceleration(state);
  for (int row = 0; row < state.mesh.nodes.numLattice + state.mesh.nodes.numEnriched; ++row)
  {
    const double a = k * state.mesh.grid.nodePosition(latticeNode(state.mesh.nodes, row))[0] - phase;
    motion(row, 0) = -speed * k * amplitude * std::cos(a);
    acceleration(row, 0) = -speed * speed * k * k * amplitude * std::sin(a);
    motion(row, 1) = motion(row, 2) = 0.0;
  }
  const std::vector<double> J = releaseOfAll(state, state.cracks.fronts.at(0), acceleration);
  // The largest sum of strain and kinetic energy, across the tube. Linear interpolation of nodal motion is
  // off by (k cell)^2 / 8, its gradient and the particles' quadrature by as much.
  const double w = k * speed, scale = density * amplitude * amplitude * w * w * 2.0 * tube.radii.outer;
  for (const double j : J)
    EXPECT_NEAR(j, 0.0, k * cell * k * cell / 8.0 * scale);
}

/// A body turned as a whole has what it had.
TEST(Fronts3D, AreTheSameWhenEverythingTurns)
{
  const auto run = straightFront();
  State<3>& state = run->state();
  const CrackFront<3> front = state.cracks.fronts.at(0);
  const Intensities K{1.0, 0.0, 0.0};
  const double plain = releaseAlong(state, K)[4], c = std::cos(0.5), s = std::sin(0.5);
  // The deformation of a turned body, with the particles left where the tube is.
  const auto F = state.particles.real<gradientSize<3>>(fields::deformation);
  for (int p = 0; p < state.particles.size(); ++p)
  {
    double G[9];
    for (int i = 0; i < 3; ++i) // F Q^T with Q a turn about z: the undeformed body is the turned one
    {
      G[3 * i] = c * F(p, 3 * i) - s * F(p, 3 * i + 1);
      G[3 * i + 1] = s * F(p, 3 * i) + c * F(p, 3 * i + 1);
      G[3 * i + 2] = F(p, 3 * i + 2);
    }
    for (int k = 0; k < 9; ++k)
      F(p, k) = G[k];
  }
  const double turned = releaseOfAll(state, front, noAcceleration(state))[4];
  EXPECT_NEAR(turned, plain, 1e-6 * plain);
}

/// Nodes of a front around which no material is left have no J, and keep the last for their driving force;
/// the others have one.
TEST(Fronts3D, HaveNoReleaseWithoutMaterialInTheirTube)
{
  const auto run = straightFront();
  State<3>& state = run->state();
  CrackFront<3>& front = state.cracks.fronts.at(0);
  const Intensities K{smallK.modeI, smallK.modeII, 0.0};
  const CrackFront<3> before = front;
  deform(state, [&](const Vector<3>& x, int side) { return tipField(K, before, x, side); });
  DrivingForces<3> driving;
  driving.computeRelease(state);
  for (const FrontNode<3>& node : front.nodes)
  {
    EXPECT_FALSE(node.driving.lost);
    EXPECT_GT(node.driving.release, 0.0);
  }
  const std::vector<FrontNode<3>> known = front.nodes;
  // The nodes of the further half lie outside of the body, each as far from the next as before.
  const std::size_t count = front.nodes.size(), half = count / 2;
  for (std::size_t k = half; k < count; ++k)
    front.nodes[k].position = front.nodes[k].position + 30.0 * cell * front.normal;
  driving.computeRelease(state);
  EXPECT_FALSE(front.nodes.front().driving.lost);
  EXPECT_TRUE(front.nodes.back().driving.lost);
  EXPECT_EQ(front.nodes.back().driving.release, known.back().driving.release);
}

/// The ratios of the openings' roots, and, as the faces have them exactly, their size.
TEST(Fronts3D, DivideModesByTheOpenings)
{
  const auto run = straightFront();
  State<3>& state = run->state();
  const CrackFront<3>& front = state.cracks.fronts.at(0);
  openFaces(state, smallK);
  const Elasticity e = elasticity(state.materials.properties[0]);
  const std::vector<Intensities> all =
      openingsBehind(state.cracks, front, lineOf(front), e, cell, tube.halfWidth);
  // A chord of the root over a cell, a cell behind the front, is low by less than 1 / 32 of it.
  for (const Intensities& K : all)
  {
    EXPECT_NEAR(K.modeII / K.modeI, smallK.modeII / smallK.modeI, 1e-8);
    EXPECT_NEAR(K.modeIII / K.modeI, smallK.modeIII / smallK.modeI, 1e-8);
    EXPECT_NEAR(K.modeI, smallK.modeI, smallK.modeI / 32.0);
  }
  const Intensities scaled = scaleTo(all[0], 3.0 * exactRelease(smallK), e);
  EXPECT_NEAR(releaseOf(scaled, e), 3.0 * exactRelease(smallK), 1e-12);
  EXPECT_NEAR(scaled.modeIII / scaled.modeI, all[0].modeIII / all[0].modeI, 1e-12);
  EXPECT_EQ(scaleTo(all[0], -1.0, e).modeI, 0.0);
}

/// Faces that turn away behind the front have their openings in a frame that turns with them by half, until
/// the front has grown and may have kinked.
TEST(Fronts3D, DivideModesOnCurvedFaces)
{
  const auto run = straightFront();
  State<3>& state = run->state();
  CrackFront<3>& front = state.cracks.fronts.at(0);
  openFaces(state, smallK);
  const double radius = 8.0 * cell, longest = 1.5 * cell; // edges of triangles
  bendFaces(state, radius);
  const Elasticity e = elasticity(state.materials.properties[0]);
  const auto all = [&]
  { return openingsBehind(state.cracks, front, lineOf(front), e, cell, tube.halfWidth); };
  // The normal of a triangle is right in its middle. With half its length of the turn to either side,
  // openings that grow as the root of the distance s >= cell: int (x / R) (1 + x / 2 s) dx = h^2 / (24 R s).
  const double bound = longest * longest / (24.0 * radius * cell);
  for (const Intensities& K : all())
  {
    EXPECT_NEAR(K.modeII / K.modeI, smallK.modeII / smallK.modeI, 2.0 * bound);
    EXPECT_NEAR(K.modeIII / K.modeI, smallK.modeIII / smallK.modeI, 2.0 * bound);
  }
  front.grown = true; // in its own frame, from which the openings have turned by 1 to 3 cells over 2 R
  for (const Intensities& K : all())
    EXPECT_GT(std::abs(K.modeII / K.modeI - smallK.modeII / smallK.modeI), 0.5 * cell / radius);
}

TEST(Fronts3D, KnowHowMuchTheyAreCurved)
{
  Teuchos::ParameterList scene = blockScene({16e-3, 16e-3, 10e-3});
  const double radius = 5e-3;
  setCrack(scene, regularPolygon({8.1e-3, 7.8e-3, 5.2e-3}, radius, 32));
  const auto penny = start<3>(scene);
  const FrontLine line = lineOf(penny->state().cracks.fronts.at(0));
  ASSERT_EQ(line.loop.size(), 1u);
  EXPECT_NEAR(line.loop[0], 32 * 2.0 * radius * std::sin(pi / 32), 1e-12);
  EXPECT_NEAR(radiusOfCurvature(line, cell), radius, 1e-9);
  // A front node that points 15 degrees aside, as next to one that lies behind, hardly is curvature: a third
  // of its turn counts, which over 3 cells or more has the sagitta of a circle of 3 / (2 sin(5 degrees))
  // = 17.2 cells, where the front node alone has that of one of 5.8 cells.
  FrontLine aside = line;
  Vector<3>& direction = aside.nodes[10].direction;
  const Vector<3> other{-direction[1], direction[0], 0.0};
  direction = std::cos(pi / 12.0) * direction + std::sin(pi / 12.0) * other;
  EXPECT_GT(radiusOfCurvature(aside, cell), 1.0 / (1.0 / radius + 1.0 / (17.2 * cell)));
  // Distance to the surface: the nodes on it are less than half covered.
  EXPECT_GT(clearAround(penny->state(), penny->state().cracks.fronts.at(0), 6e-3), 2.2e-3);
  EXPECT_LE(clearAround(penny->state(), penny->state().cracks.fronts.at(0), 6e-3), 3.2e-3);
  const auto straight = straightFront();
  const FrontLine open = lineOf(straight->state().cracks.fronts.at(0));
  EXPECT_EQ(open.loop, std::vector<double>{0.0});
  EXPECT_TRUE(std::isinf(radiusOfCurvature(open, cell)) || radiusOfCurvature(open, cell) > 1e3);
  double fraction = 0.0;
  for (const FrontNode<3>& frontNode : open.nodes)
    fraction += frontNode.tributaryLength;
  EXPECT_NEAR(fraction, depth, 1e-12);
}

/// What docs/explanation/energy-release.md says of the tube.
TEST(Fronts3D, HaveATubeOfTwoAndAHalfToFiveCells)
{
  const ContourRadii radii = usualRadii(usualCells<3>(), cell);
  EXPECT_DOUBLE_EQ(radii.inner, 2.5 * cell);
  EXPECT_DOUBLE_EQ(radii.outer, 5.0 * cell);
  // The block is 12 cells wide and the front 6.3 and 6.2 cells off its corner, so that it fits, with little
  // to spare.
  const auto straight = straightFront();
  const CrackFront<3>& front = straight->state().cracks.fronts.at(0);
  const FrontTube fitting = fittingTube(straight->state(), front, usualCells<3>());
  EXPECT_DOUBLE_EQ(fitting.radii.outer, radii.outer);
  EXPECT_DOUBLE_EQ(fitting.radii.inner, radii.inner);
  EXPECT_DOUBLE_EQ(fitting.halfWidth, 2.0 * cell);
}
