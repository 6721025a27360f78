/// Equations 1 to 3 of the C-SAFE report, by hand and on a beam.
#include "CrackedBeam.hpp"

#include "cracks/Normals.hpp"
#include "cracks/Visibility.hpp"
#include "transfer/Stencils.hpp"

#include <cmath>
#include <map>

using namespace Rhegma;
using namespace Rhegma::cracks;
using namespace Rhegma::cracks::test;

namespace
{

/// Corners of a unit cell as they are numbered here: (0,0), (1,0), (0,1), (1,1).
using Corners = std::array<int, 4>;

/// The stencil of a point in a unit cell whose corners lie on given sides of a crack: weight and slope of
/// each corner.
struct Cell
{
  std::array<double, 4> weight, slopeX, slopeY;
};

Cell cellSeenFrom(const Corners& cornerSide, const Vector<2>& position, int side)
{
  State<2> state;
  state.mesh.grid = makeGrid<2>({0.0, 0.0}, {1.0, 1.0}, 1.0);
  state.cracks.nodeSide = View<int*>("nodeSide", state.mesh.grid.numNodes);
  state.cracks.dualField = false;
  const auto nodeSide = Kokkos::create_mirror_view(state.cracks.nodeSide);
  int corner[4];
  for (int c = 0; c < 4; ++c)
  {
    const int at[2] = {gridMargin + c % 2, gridMargin + c / 2};
    corner[c] = state.mesh.grid.nodeIndex(at);
    nodeSide(corner[c]) = cornerSide[c];
  }
  Kokkos::deep_copy(state.cracks.nodeSide, nodeSide);
  state.stored.editors.resize(1);
  state.stored.editors[0].edit =
      [](const State<2>& s, const ObservedPoints<2>& points, const StencilTable<2>& table)
  { editStencils(s, Formulation::BrokenCell, {}, points, table); };
  ObservedPoints<2> points;
  points.count = 1;
  points.position = View<double* [2]>("position", 1);
  points.half = View<double* [2]>("half", 1);
  points.side = View<int*>("side", 1);
  for (int d = 0; d < 2; ++d)
    Kokkos::deep_copy(Kokkos::subview(points.position, 0, d), position[d]);
  Kokkos::deep_copy(points.side, side);
  StencilTable<2> table;
  pointStencils(state, points, table, false);
  const auto count = onHost(table.count);
  const auto node = onHost(table.node);
  const auto weight = onHost(table.weight);
  const auto slope = onHost(table.slope);
  Cell cell{};
  for (int k = 0; k < count(0); ++k)
    for (int c = 0; c < 4; ++c)
      if (node(0, k) == corner[c])
      {
        cell.weight[c] += weight(0, k);
        cell.slopeX[c] += slope(0, k, 0);
        cell.slopeY[c] += slope(0, k, 1);
      }
  return cell;
}

void expectNear(const std::array<double, 4>& found, const std::array<double, 4>& expected)
{
  // Products and sums of numbers below 1.
  for (int c = 0; c < 4; ++c)
    EXPECT_NEAR(found[c], expected[c], 1e-15) << "corner " << c;
}

} // namespace

/// A crack along y = 1/2. From (1/4, 1/4) the unbroken functions are 9/16, 3/16, 3/16, 1/16; the upper two,
/// together 1/4, are invisible, so each of the two visible ones takes 1/8.
TEST(BrokenCell, DividesAmongTwoCorners)
{
  const Corners sides{-1, -1, 1, 1};
  const Cell cell = cellSeenFrom(sides, {0.25, 0.25}, -1);
  expectNear(cell.weight, {9.0 / 16 + 1.0 / 8, 3.0 / 16 + 1.0 / 8, 0.0, 0.0});
  // d/dx of the upper two adds up to 0, d/dy to 1.
  expectNear(cell.slopeX, {-0.75, 0.75, 0.0, 0.0});
  expectNear(cell.slopeY, {-0.75 + 0.5, -0.25 + 0.5, 0.0, 0.0});
  // From the other side, at the mirrored position, the mirrored weights.
  expectNear(cellSeenFrom(sides, {0.25, 0.75}, 1).weight, {0.0, 0.0, 11.0 / 16, 5.0 / 16});
}

/// The front lies in the cell: only the left corners are behind it. One of four is invisible, 3/16 of it.
TEST(BrokenCell, DividesAmongThreeCornersAtTheFront)
{
  const Cell cell = cellSeenFrom({-1, 0, 1, 0}, {0.25, 0.25}, -1);
  expectNear(cell.weight, {9.0 / 16 + 1.0 / 16, 3.0 / 16 + 1.0 / 16, 0.0, 1.0 / 16 + 1.0 / 16});
  // The invisible corner's slopes are -1/4 and 3/4.
  expectNear(cell.slopeX, {-0.75 - 1.0 / 12, 0.75 - 1.0 / 12, 0.0, 0.25 - 1.0 / 12});
  expectNear(cell.slopeY, {-0.75 + 0.25, -0.25 + 0.25, 0.0, 0.25 + 0.25});
}

/// A crack cuts off one corner. From the middle, three nodes get the fourth's 1/4; from beyond, one is all
/// that is seen, so it has all the weight and no slope.
TEST(BrokenCell, DividesAmongThreeCornersAndOne)
{
  const Corners sides{-1, -1, -1, 1};
  expectNear(cellSeenFrom(sides, {0.5, 0.5}, -1).weight, {1.0 / 3, 1.0 / 3, 1.0 / 3, 0.0});
  const Cell beyond = cellSeenFrom(sides, {0.9, 0.8}, 1);
  expectNear(beyond.weight, {0.0, 0.0, 0.0, 1.0});
  expectNear(beyond.slopeX, {0.0, 0.0, 0.0, 0.0});
  expectNear(beyond.slopeY, {0.0, 0.0, 0.0, 0.0});
}

/// A particle that sees no corner keeps its stencil, and one away from cracks is left alone.
TEST(BrokenCell, LeavesTheIsolatedAndTheFarAlone)
{
  const std::array<double, 4> unbroken{9.0 / 16, 3.0 / 16, 3.0 / 16, 1.0 / 16};
  expectNear(cellSeenFrom({1, 1, 1, 1}, {0.25, 0.25}, -1).weight, unbroken);
  expectNear(cellSeenFrom({1, 1, -1, -1}, {0.25, 0.25}, 0).weight, unbroken);
  // Nodes of another crack have no effect.
  expectNear(cellSeenFrom({2, 2, -2, -2}, {0.25, 0.25}, -1).weight, unbroken);
}

/// Eq. 3 is not linearly complete. In the cell of the first case a rigid rotation w gives
/// e_yy = w (1/2 - x) and e_xy = w (1 - y) / 2: half of w close to the lower corners.
TEST(BrokenCell, StrainsARigidRotation)
{
  const auto strain = [](const Vector<2>& position)
  {
    const Cell cell = cellSeenFrom({-1, -1, 1, 1}, position, -1);
    double gradient[2][2] = {};
    for (int c = 0; c < 4; ++c)
    {
      const double velocity[2] = {-double(c / 2), double(c % 2)}; // of a rotation of 1/s about (0, 0)
      for (int i = 0; i < 2; ++i)
      {
        gradient[i][0] += velocity[i] * cell.slopeX[c];
        gradient[i][1] += velocity[i] * cell.slopeY[c];
      }
    }
    return std::array<double, 3>{gradient[0][0], gradient[1][1], 0.5 * (gradient[0][1] + gradient[1][0])};
  };
  const auto quarter = strain({0.25, 0.25});
  EXPECT_NEAR(quarter[0], 0.0, 1e-15);
  EXPECT_NEAR(quarter[1], 0.25, 1e-15);
  EXPECT_NEAR(quarter[2], 0.375, 1e-15);
  EXPECT_NEAR(strain({0.5, 1e-12})[2], 0.5, 1e-11);
}

/// On a beam: weights add up to one, slopes to none, and nothing is seen of invisible nodes.
TEST(BrokenCell, SumsToOneAndIsZeroAtInvisibleNodes)
{
  for (const std::string shape : {"Linear", "GIMP"})
    for (const std::string& points : {onRow, withinTolerance, midCell, inclined, steep})
    {
      const auto run = beamAtRest("Broken Cell", shape, points);
      const State<2>& state = run->state();
      const auto nodeSide = onHost(state.cracks.nodeSide);
      int cut = 0, isolated = 0;
      for (const Seeing& one : stencilsNearCrack(state))
      {
        double weight = 0.0, invisible = 0.0, slope[2] = {0.0, 0.0}, visible = 0.0;
        for (const Entry& entry : one.entries)
        {
          weight += entry.weight;
          for (int d = 0; d < 2; ++d)
            slope[d] += entry.slope[d];
          const bool hidden = one.side != 0 && nodeSide(entry.node) == -one.side;
          (hidden ? invisible : visible) += std::fabs(entry.weight);
          cut += hidden ? 1 : 0;
        }
        // Nine entries of at most 1 and 2 / cell.
        EXPECT_NEAR(weight, 1.0, 9e-16 * 4);
        for (int d = 0; d < 2; ++d)
          EXPECT_NEAR(slope[d] * cell, 0.0, 9e-16 * 8);
        if (visible > 0.0)
          EXPECT_EQ(invisible, 0.0);
        else
          ++isolated;
      }
      EXPECT_GT(cut, 100) << points;
      double mass = 0.0;
      for (const double m : nodalMasses(state))
        mass += m;
      EXPECT_NEAR(mass, bodyMass(state), 1e-13 * bodyMass(state)) << shape << points << isolated;
    }
}

/// A particle on its own beyond a row that counts as above the crack sees no corner; its mass stays on the
/// grid.
TEST(BrokenCell, KeepsTheMassOfAParticleThatSeesNoNode)
{
  for (const std::string formulation : {"Broken Cell", "Corrected Broken Cell", "Dual Field"})
  {
    const auto run = beamAtRest(formulation, "Linear", withinTolerance);
    State<2>& state = run->state();
    const auto position = state.particles.real<2>(fields::position);
    const auto host = onHost(position);
    int moved = -1;
    for (const Seeing& one : stencilsNearCrack(state))
      if (one.side == -1 && one.x[0] > 0.02 && one.x[0] < 0.03 && one.x[1] > 0.009)
        moved = one.particle;
    ASSERT_GE(moved, 0);
    host(moved, 1) = 0.0101; // below the crack, in the cell whose corners all count as above it
    Kokkos::deep_copy(position, host);
    run->step(2e-15, false);
    bool seesNone = false;
    const auto nodeSide = onHost(state.cracks.nodeSide);
    const int at[2] = {static_cast<int>(state.mesh.grid.inCells(host(moved, 0), 0)),
                       static_cast<int>(state.mesh.grid.inCells(0.0101, 1))};
    seesNone = nodeSide(state.mesh.grid.nodeIndex(at)) == 1 &&
               nodeSide(state.mesh.grid.nodeIndex({at[0] + 1, at[1] + 1})) == 1;
    EXPECT_TRUE(seesNone);
    double mass = 0.0;
    for (const double m : nodalMasses(state))
      mass += m;
    EXPECT_NEAR(mass, bodyMass(state), 1e-13 * bodyMass(state)) << formulation;
  }
}

/// Nodes on the crack, or a tenth of a cell below it, are on side +1, the left of the polyline; a node at the
/// front is not split. Turning the polyline round changes the names of the sides, and so the side of these
/// nodes.
TEST(BrokenCell, TreatsEqualDistancesAlikeEverywhere)
{
  for (const std::string& points : {onRow, withinTolerance, std::string("{0.05, 0.01, 0, 0.01}")})
  {
    const auto run = beamAtRest("Broken Cell", "Linear", points);
    const State<2>& state = run->state();
    const auto nodeSide = onHost(state.cracks.nodeSide);
    const int up = points[1] == '0' && points[2] == ',' ? 1 : -1; // side of what lies above
    const auto sideAt = [&](double x, double y)
    {
      const int at[2] = {static_cast<int>(std::lround(state.mesh.grid.inCells(x, 0))),
                         static_cast<int>(std::lround(state.mesh.grid.inCells(y, 1)))};
      return nodeSide(state.mesh.grid.nodeIndex(at));
    };
    for (double x = 0.0; x < 0.0487; x += cell)
    {
      EXPECT_EQ(sideAt(x, 0.01), 1) << points << x;
      EXPECT_EQ(sideAt(x, 0.01 + cell), up);
      EXPECT_EQ(sideAt(x, 0.01 - cell), -up);
    }
    for (const double y : {0.01 - cell, 0.01, 0.01 + cell})
      EXPECT_EQ(sideAt(0.05, y), 0);
  }
}

/// Particles near the crack store the outward normal of their face; others none. No other formulation has it.
TEST(BrokenCell, GivesParticlesTheNormalOfTheirFace)
{
  const auto run = beamAtRest("Broken Cell", "GIMP", "{0, 0.0063, 0.03, 0.0103, 0.05, 0.0103}");
  const State<2>& state = run->state();
  const auto normal = onHost(state.particles.real<2>(crackNormal));
  const double slant = std::hypot(0.03, 0.004);
  int turned = 0, level = 0;
  std::map<int, int> near;
  for (const Seeing& one : stencilsNearCrack(state))
  {
    near[one.particle] = one.side;
    if (one.side == 0 || (one.x[0] > 0.028 && one.x[0] < 0.032))
      continue;
    const double out = one.side > 0 ? -1.0 : 1.0;
    const bool first = one.x[0] < 0.03;
    EXPECT_NEAR(normal(one.particle, 0), out * (first ? -0.004 / slant : 0.0), 1e-12);
    EXPECT_NEAR(normal(one.particle, 1), out * (first ? 0.03 / slant : 1.0), 1e-12);
    ++(first ? turned : level);
  }
  EXPECT_GT(turned, 50);
  EXPECT_GT(level, 50);
  for (int p = 0; p < state.particles.size(); ++p)
    EXPECT_NEAR(std::hypot(normal(p, 0), normal(p, 1)), near[p] == 0 ? 0.0 : 1.0, 1e-14);
  EXPECT_FALSE(beamAtRest("Dual Field", "GIMP", onRow)->state().particles.has(crackNormal));
}

/// Where cells are refined, masters of hanging nodes come first and sides after: particles on either side see
/// no node of the other, and what they see still sums to one.
TEST(BrokenCell, BreaksRefinedCells)
{
  for (const char* shape : {"Linear", "GIMP"})
  {
    const auto run = beamAtRest("Broken Cell", shape, midCell, {"Adaptivity:Maximum Level=2"});
    const State<2>& state = run->state();
    const auto nodeSide = onHost(state.cracks.nodeSide);
    int onFine = 0, blinded = 0;
    for (const Seeing& one : stencilsNearCrack(state))
    {
      double sum = 0.0, slope[2] = {0.0, 0.0};
      bool fine = false, hidden = false;
      for (const Entry& entry : one.entries)
      {
        sum += entry.weight;
        for (int d = 0; d < 2; ++d)
          slope[d] += entry.slope[d];
        fine = fine || entry.node >= state.mesh.grid.numNodes;
        if (one.side == 0 || nodeSide(entry.node) != -one.side)
          continue;
        hidden = true;
        EXPECT_EQ(entry.weight, 0.0);
      }
      // Sums of sixteen numbers; slopes up to 4 over a cell of the beam's quarter.
      EXPECT_NEAR(sum, 1.0, 1e-14);
      EXPECT_NEAR(std::hypot(slope[0], slope[1]) * cell / 4.0, 0.0, 1e-14);
      onFine += fine ? 1 : 0;
      blinded += fine && hidden ? 1 : 0;
    }
    EXPECT_GT(onFine, 50) << shape;
    EXPECT_GT(blinded, 10) << shape;
  }
}
