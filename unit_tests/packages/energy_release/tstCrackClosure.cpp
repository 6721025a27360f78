#include "LatticeState.hpp"

#include "energy_release/CrackClosure.hpp"

#include <gtest/gtest.h>

using namespace Rhegma;
using namespace Rhegma::energy_release;
using namespace Rhegma::energy_release::test;

namespace
{

constexpr double cell = 1e-3, traction = 2e6, opening = 1e-7;
constexpr double fullCell = cell * cell * thickness;

/// Marks the nodes behind the front that both sides can touch.
void splitNodes(State<2>& state, const CrackFront<2>& front)
{
  state.cracks.nodeSide = View<int*>("rhegma::nodeSide", state.mesh.grid.numNodes);
  for (int n = 0; n < state.mesh.grid.numNodes; ++n)
  {
    const Vector<2> from = state.mesh.grid.nodePosition(n) - front.position;
    if (dot(from, front.direction) < -0.1 * cell && std::fabs(dot(from, front.normal)) < 3.0 * cell)
      state.cracks.nodeSide(n) = dot(from, front.normal) > -0.1 * cell ? 1 : -1;
  }
}

/// Opening of a node behind the front, as a nodal field: `opening` times the number of its column to a power.
double nodalOpening(const State<2>& state, const CrackFront<2>& front, int node, double power)
{
  const double behind = -dot(state.mesh.grid.nodePosition(node) - front.position, front.direction) / cell;
  return opening * std::pow(std::ceil(behind - 0.1), power);
}

/// A crack that is open by nodal displacement of +-opening/2 and held together by a uniform traction, both
/// `along` the given unit vector: the work of closure is known exactly. \param offset of the crack from a
/// line of nodes, in cells
CrackClosure closeUniform(ShapeKind shape, const Vector<2>& direction, double offset, int columns, bool opens,
                          double power = 1.0, const RecoveryMatrix& matrix = consistentMatrix())
{
  State<2> state = makeBody(0.016, cell, Plane::Strain, shape);
  const Vector<2> normal{{-direction[1], direction[0]}};
  const Vector<2> along = opens ? normal : direction;
  CrackFront<2> front = addFront(state, 0.4 * cell * direction + offset * cell * normal, 0.0);
  front.direction = direction;
  front.normal = normal;
  splitNodes(state, front);

  const auto position = state.particles.real<2>(fields::position);
  const auto stress = state.particles.real<symmetricSize<2>>(fields::stress);
  const auto box = state.particles.real<2>(fields::box);
  for (int p = 0; p < state.particles.size(); ++p)
  {
    // Particles keep their positions, and move their reference positions back by what the nodes give.
    const Vector<2> x{{position(p, 0), position(p, 1)}};
    const int side = dot(x - front.position, normal) > 0.0 ? 1 : -1;
    double value = 0.0;
    const auto add = [&](const auto& axisX, const auto& axisY, int width)
    {
      for (int i = 0; i < width; ++i)
        for (int j = 0; j < width; ++j)
        {
          const int node =
              (axisX.first + i) * state.mesh.grid.stride[0] + (axisY.first + j) * state.mesh.grid.stride[1];
          const bool split = state.cracks.nodeSide(node) != 0;
          value += axisX.weight[i] * axisY.weight[j] *
                   (split ? 0.5 * side * nodalOpening(state, front, node, power) : 0.0);
        }
    };
    const double at[2] = {state.mesh.grid.inCells(x[0], 0), state.mesh.grid.inCells(x[1], 1)};
    if (shape == ShapeKind::Linear)
      add(linearStencil(at[0]), linearStencil(at[1]), 2);
    else
      add(gimpStencil(at[0], box(p, 0) / cell), gimpStencil(at[1], box(p, 1) / cell), 3);
    const auto reference = state.particles.real<2>(fields::reference);
    for (int d = 0; d < 2; ++d)
      reference(p, d) = x[d] - value * along[d];
    stress(p, 0) = traction * 2.0 * along[0] * normal[0];
    stress(p, 1) = traction * 2.0 * along[1] * normal[1];
    stress(p, 2) = traction * (along[0] * normal[1] + along[1] * normal[0]);
    if (opens)
      for (int k = 0; k < 3; ++k)
        stress(p, k) *= 0.5;
  }
  return closeCrack(state, front, columns, matrix);
}

/// The tip lies 0.4 cells past a column, so that columns behind open by 1, 2, ... and G = traction (sum of
/// openings that m columns close) / (2 m). The blend with row sums moves nodal displacement by less than a
/// thousandth of the difference between lumped and consistent, which is at most the opening's change over a
/// cell or two.
void checkUniform(ShapeKind shape, const Vector<2>& direction, double offset, bool opens)
{
  const double tolerance = 2e-3 * traction * opening;
  EXPECT_NEAR(closeUniform(shape, direction, offset, 1, opens).chosen, 0.5 * traction * opening, tolerance);
  EXPECT_NEAR(closeUniform(shape, direction, offset, 2, opens).chosen, 0.25 * traction * 3.0 * opening,
              tolerance);
}

} // namespace

TEST(CrackClosure, IsExactOnALineOfNodes)
{
  checkUniform(ShapeKind::Linear, {{1.0, 0.0}}, 0.0, true);
  checkUniform(ShapeKind::Gimp, {{1.0, 0.0}}, 0.0, true);
}

TEST(CrackClosure, AddsTheRowsOfACrackBetweenLines)
{
  checkUniform(ShapeKind::Linear, {{1.0, 0.0}}, 0.5, true);
  checkUniform(ShapeKind::Gimp, {{1.0, 0.0}}, 0.5, true);
}

TEST(CrackClosure, KnowsEveryDirectionOfTheGrid)
{
  checkUniform(ShapeKind::Linear, {{-1.0, 0.0}}, 0.0, true);
  checkUniform(ShapeKind::Gimp, {{0.0, 1.0}}, 0.5, true);
  checkUniform(ShapeKind::Linear, {{0.0, -1.0}}, 0.0, true);
}

TEST(CrackClosure, CountsSliding)
{
  checkUniform(ShapeKind::Linear, {{1.0, 0.0}}, 0.0, false);
  checkUniform(ShapeKind::Gimp, {{0.0, 1.0}}, 0.5, false);
}

/// Of a constant opening, lumping gives the first column 13/16: with particles at quarters of the cells, 3/16
/// come from the closed column ahead.
TEST(CrackClosure, LumpedProjectionSmearsTheOpening)
{
  const CrackClosure result = closeUniform(ShapeKind::Linear, {{1.0, 0.0}}, 0.0, 1, true, 0.0);
  EXPECT_NEAR(result.chosen, 0.5 * traction * opening, 2e-3 * traction * opening);
  EXPECT_NEAR(result.lumped, 13.0 / 16.0 * 0.5 * traction * opening, 1e-9 * traction * opening);
}

/// The matrix of the motion: with no particle unlumped it is that of row sums, with all of them the
/// consistent one; a series of one term is that of row sums, and of many terms the solution, as its error
/// falls with every term.
TEST(CrackClosure, RecoversTheOpeningWithTheChosenMatrix)
{
  const auto release = [](const RecoveryMatrix& matrix) {
    return closeUniform(ShapeKind::Linear, {{1.0, 0.0}}, 0.0, 1, true, 0.0, matrix).chosen;
  };
  const auto series = [&](int terms)
  {
    RecoveryMatrix matrix = consistentMatrix();
    matrix.terms = terms;
    return release(matrix);
  };
  const double lumped = release(lumpedMatrix()), consistent = release(consistentMatrix());
  const double unit = traction * opening;
  EXPECT_NEAR(lumped, 13.0 / 32.0 * unit, 1e-9 * unit);
  RecoveryMatrix farAway = consistentMatrix();
  farAway.radius = -1.0;
  EXPECT_NEAR(release(farAway), lumped, 1e-9 * unit);
  farAway.radius = 4.0 * cell;
  farAway.edge = cell;
  // The influence of a node falls to a quarter from node to node.
  EXPECT_NEAR(release(farAway), consistent, 0.1 * unit * std::pow(0.25, 3.0));
  RecoveryMatrix emptyCells = consistentMatrix();
  emptyCells.smallestNode = 1.1; // no node inside is so heavy
  EXPECT_NEAR(release(emptyCells), lumped, 1e-9 * unit);
  EXPECT_NEAR(series(1), lumped, 1e-9 * unit);
  EXPECT_GT(std::fabs(series(2) - consistent), std::fabs(series(8) - consistent));
  EXPECT_NEAR(series(64), consistent, 2e-3 * unit);
}

TEST(CrackClosure, IsNoNumberForAnInclinedCrack)
{
  State<2> state = makeBody(0.01, cell, Plane::Strain, ShapeKind::Linear);
  const CrackFront<2> front = addFront(state, {{0.0, 0.0}}, 0.3);
  splitNodes(state, front);
  EXPECT_FALSE(runsAlongGrid(front));
  EXPECT_TRUE(std::isnan(closeCrack(state, front, 1, consistentMatrix()).chosen));
}

/// A linear displacement on each side is recovered at every node behind and ahead by the consistent
/// projection.
TEST(TipPatch, RecoversLinearDisplacement)
{
  State<2> state = makeBody(0.016, cell, Plane::Strain, ShapeKind::Gimp);
  const CrackFront<2> front = addFront(state, {{0.4 * cell, 0.5 * cell}}, 0.0);
  splitNodes(state, front);
  deform(state,
         [](const Vector<2>& x) {
           return Displacement{{{1e-6 + 1e-4 * x[1], -2e-4 * x[0]}}, {0.0, 1e-4, -2e-4, 0.0}};
         });
  const SplitNodes split(state, front, 1e300);
  const NodeDisplacement found =
      recoverDisplacement(particlesAround(state, front, 8.0 * cell), split, consistentMatrix(), fullCell);
  EXPECT_GT(found.size(), 200u);
  for (const auto& entry : found)
  {
    const Vector<2> x = state.mesh.grid.nodePosition(entry.first.first);
    if (norm(x - front.position) > 6.0 * cell)
      continue;
    // Particles are 1e-6 away from where they were, and 1e-3 of the lumped value at the faces is off by a
    // cell's worth.
    EXPECT_NEAR(entry.second[0], 1e-6 + 1e-4 * x[1], 2e-3 * 1e-4 * cell + 1e-9);
    EXPECT_NEAR(entry.second[1], -2e-4 * x[0], 2e-3 * 2e-4 * cell + 1e-9);
  }
}
