/// Boxes that end at rows of nodes, for the stiffness of large systems.

#include "equilibrium/ClippedBoxes.hpp"
#include "equilibrium/RowOwners.hpp"
#include "equilibrium/Unknowns.hpp"
#include "src/step/Bodies.hpp"
#include "transfer/ParticleViews.hpp"

#include <algorithm>

namespace Rhegma
{
namespace Test
{

namespace
{

/// A cube of four cells, moved from the rows of nodes by a part of a cell. The boxes of its particles are
/// half a cell wide.
Teuchos::ParameterList movedCube(double by)
{
  Teuchos::ParameterList scene = emptyScene<3>(all<3>(-2.0), all<3>(8.0), 1.0, "MUSL", "GIMP");
  scene.sublist("Time").set("Analysis", "Static");
  scene.sublist("Time").set("Rigid Modes", "Remove");
  scene.sublist("Time").set("Final Time", 1.0);
  addMaterial(scene, "Neo-Hookean", 0.3);
  addBox<3>(scene, "Block", all<3>(by), all<3>(4.0 + by));
  return scene;
}

struct Seen
{
  int nodes = 0;
  double slopes = 0.0, identity = 0.0; ///< largest errors of linear displacements
};

/// What the stencil of a particle with other boxes sees, and how well it represents linear displacements.
template <class Connect>
Seen see(const State<3>& state, const Connect& connect, int p)
{
  const NodePositions<3> positions = nodePositions(state);
  Seen seen;
  double sum[3] = {}, moment[3][3] = {};
  connect.visitStraining(p,
                         [&](int node, double weight, const auto& slopes)
                         {
                           if (!equilibrium::counts(weight, slopes.of, slopes.size, 1.0))
                             return;
                           ++seen.nodes;
                           for (int i = 0; i < 3; ++i)
                             for (int j = 0; j < 3; ++j)
                             {
                               sum[j] += i == 0 ? slopes(i, j) : 0.0;
                               moment[i][j] += positions(node)[i] * slopes(i, j);
                             }
                         });
  for (int i = 0; i < 3; ++i)
  {
    seen.slopes = std::max(seen.slopes, std::fabs(sum[i]));
    for (int j = 0; j < 3; ++j)
      seen.identity = std::max(seen.identity, std::fabs(moment[i][j] - (i == j ? 1.0 : 0.0)));
  }
  return seen;
}

} // namespace

/// Particles whose boxes reach over rows of nodes by 0.6 % see the nodes of one cell, but for those beyond
/// which no others are: the layers at three faces, 8^3 - 7^3 particles.
TEST(ClippedBoxes, EndAtRowsOfNodes)
{
  Rhegma::Run<3> run(validated(movedCube(0.003)));
  run.initialize();
  const State<3>& state = run.state();
  const equilibrium::ClippedBoxes<3> boxes =
      equilibrium::clipBoxes(state, equilibrium::Clipping::LittleBeyondCells);
  ASSERT_TRUE(boxes.any());
  const auto position = state.particles.real<3>(fields::position);
  int wide = 0;
  withStraining(state,
                [&](const auto& connect)
                {
                  for (int p = 0; p < state.particles.size(); ++p)
                  {
                    const Seen seen = see(state, boxes.in(connect), p);
                    bool outermost = false;
                    for (int d = 0; d < 3; ++d)
                      outermost = outermost || position(p, d) > 3.5;
                    EXPECT_EQ(seen.nodes > 8, outermost) << p;
                    wide += seen.nodes > 8 ? 1 : 0;
                    EXPECT_LT(seen.slopes, 1e-12);
                    EXPECT_LT(seen.identity, 1e-12);
                  }
                });
  EXPECT_EQ(wide, 8 * 8 * 8 - 7 * 7 * 7);
}

TEST(ClippedBoxes, KeepTheirRowsAndLongReaches)
{
  Rhegma::Run<3> run(validated(movedCube(0.003)));
  run.initialize();
  const State<3>& state = run.state();
  equilibrium::RowGraph clipped = equilibrium::numberRows(state), whole = equilibrium::numberRows(state);
  equilibrium::connectRows(state, {}, equilibrium::clipBoxes(state, equilibrium::Clipping::LittleBeyondCells),
                           equilibrium::RowOwners(), clipped);
  equilibrium::connectRows(state, {}, equilibrium::ClippedBoxes<3>(), equilibrium::RowOwners(), whole);
  EXPECT_EQ(clipped.rows, 6 * 6 * 6);
  EXPECT_LT(2 * clipped.column.extent(0), whole.column.extent(0) * 3);
  for (int r = 0; r < clipped.rows; ++r)
    EXPECT_GT(clipped.first(r + 1) - clipped.first(r), 7) << r;
  for (const double by : {0.0, 0.1})
  {
    Rhegma::Run<3> other(validated(movedCube(by)));
    other.initialize();
    EXPECT_FALSE(equilibrium::clipBoxes(other.state(), equilibrium::Clipping::LittleBeyondCells).any()) << by;
    EXPECT_EQ(equilibrium::spanSeveralCells(other.state()), by > 0.0);
  }
}

/// Of a cube that is moved by a tenth of a cell every second box along an axis reaches over a row of nodes.
/// Boxes in one cell couple a node with 27; nodes outside the cube, which no centre of a particle is next to,
/// keep what holds them.
TEST(ClippedBoxes, EndAtTheirCells)
{
  Rhegma::Run<3> run(validated(movedCube(0.1)));
  run.initialize();
  const State<3>& state = run.state();
  const equilibrium::ClippedBoxes<3> boxes = equilibrium::clipBoxes(state, equilibrium::Clipping::ToOneCell);
  ASSERT_TRUE(boxes.any());
  withStraining(state,
                [&](const auto& connect)
                {
                  for (int p = 0; p < state.particles.size(); ++p)
                  {
                    const Seen seen = see(state, boxes.in(connect), p);
                    EXPECT_LT(seen.slopes, 1e-12);
                    EXPECT_LT(seen.identity, 1e-12);
                  }
                });
  equilibrium::RowGraph clipped = equilibrium::numberRows(state), whole = equilibrium::numberRows(state);
  equilibrium::connectRows(state, {}, boxes, equilibrium::RowOwners(), clipped);
  equilibrium::connectRows(state, {}, equilibrium::ClippedBoxes<3>(), equilibrium::RowOwners(), whole);
  for (int r = 0; r < clipped.rows; ++r)
  {
    const Vector<3> x = nodePositions(state)(clipped.nodeOf(r));
    const int count = clipped.first(r + 1) - clipped.first(r);
    if (std::all_of(&x[0], &x[0] + 3, [](double at) { return at > 0.5 && at < 2.5; }))
    {
      EXPECT_EQ(count, 27) << r;
    }
    EXPECT_GT(count, 7) << r;
    EXPECT_LE(count, whole.first(r + 1) - whole.first(r)) << r;
  }
}

} // namespace Test
} // namespace Rhegma
