/// Nodal fields where cells change, where a rank gets other nodes, and in checkpoints.

#include "../grid/RandomTrees.hpp"

#include "archive/Archive.hpp"
#include "parallel/NodalFieldTable.hpp"
#include "state/StateArchive.hpp"
#include "state/Subdomain.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <stdexcept>

namespace Rhegma
{
namespace Test
{

namespace
{

template <int D>
struct Cells
{
  Grid<D> grid = lattice<D>();
  Tree<D> tree;
  int perNode = 1;

  void refine(int deepest, std::mt19937& engine) { buildTree(randomBranches(grid, deepest, engine), tree); }

  NodalFieldNodes<D> nodes() const
  {
    NodalFieldNodes<D> all;
    all.grid = grid;
    all.finePosition = tree.finePosition;
    all.generation = tree.generation;
    all.perNode = perNode;
    return all;
  }
  int size() const { return grid.numNodes + tree.numFine; }
  Vector<D> position(int node) const { return NodePositions<D>{grid, tree.finePosition}(node); }
};

/// A part of the lattice, as a rank has it.
template <int D>
Cells<D> window(const Cells<D>& whole, int from, int cells)
{
  Cells<D> part;
  part.grid.before[0] = from;
  part.grid.cells[0] = cells;
  part.grid.origin[0] = whole.grid.origin[0] + from * whole.grid.spacing;
  numberNodes(part.grid);
  return part;
}

template <int D>
double linear(const Vector<D>& x)
{
  double value = 1.5;
  for (int d = 0; d < D; ++d)
    value += (d + 1) * x[d];
  return value;
}

/// Gives each node the value of a linear function, and minus it where it is enriched.
template <int D>
void fill(const NodalFieldTable<D>& table, const std::string& name, const Cells<D>& cells)
{
  const auto values = table.scalar(name);
  const int width = static_cast<int>(values.extent(0)) / cells.size();
  for (int n = 0; n < cells.size(); ++n)
    for (int e = 0; e < width; ++e)
      values(width * n + e) = (e == 0 ? 1.0 : -1.0) * linear(cells.position(n));
}

template <int D>
bool isThere(const Cells<D>& cells, const Vector<D>& position)
{
  const NodeIdentities<D> nodes(cells.grid, cells.tree.finePosition);
  for (int n = 0; n < cells.size(); ++n)
    if (norm(cells.position(n) - position) < 1e-9)
      return nodes.find(nodes.of(n)) == n;
  return false;
}

template <int D>
void checkRemeshing()
{
  std::mt19937 engine(7 + D);
  Cells<D> cells;
  cells.perNode = 2;
  NodalFieldTable<D> table;
  table.add({{"kept", 1, "", ""}, OnRemesh::Keep, false, true});
  table.add({{"interpolated", 1, "", ""}, OnRemesh::Interpolate, true});
  table.add({{"dropped", 1, "", ""}, OnRemesh::Drop});
  cells.refine(3, engine);
  table.move(cells.nodes(), 0, {});
  EXPECT_EQ(table.lastRemesh(), -1);
  for (int step = 1; step < 8; ++step)
  {
    fill(table, "kept", cells);
    fill(table, "interpolated", cells);
    fill(table, "dropped", cells);
    const Cells<D> before = cells;
    cells.refine(D == 2 ? 4 : 3, engine);
    table.move(cells.nodes(), step, {});
    EXPECT_EQ(table.lastRemesh(), step);
    ASSERT_EQ(static_cast<int>(table.scalar("kept").extent(0)), cells.size());
    int lost = 0;
    for (int n = before.grid.numNodes; n < before.size(); ++n)
      lost += isThere(cells, before.position(n)) ? 0 : 1;
    EXPECT_EQ(static_cast<int>(table.lost("kept").size()), lost);
    for (const auto& node : table.lost("kept"))
      EXPECT_NEAR(node.values[0], linear(node.position), 1e-12);
    for (int n = 0; n < cells.size(); ++n)
    {
      const double value = linear(cells.position(n));
      EXPECT_EQ(table.scalar("dropped")(n), 0.0);
      EXPECT_NEAR(table.scalar("interpolated")(2 * n), value, 1e-12);
      EXPECT_NEAR(table.scalar("interpolated")(2 * n + 1), -value, 1e-12);
      EXPECT_NEAR(table.scalar("kept")(n), isThere(before, cells.position(n)) ? value : 0.0, 1e-12);
    }
    table.move(cells.nodes(), step + 1, {});
    EXPECT_TRUE(table.lost("kept").empty());
    EXPECT_EQ(table.lastRemesh(), step);
  }
}

} // namespace

TEST(NodalFieldTable, FollowsRefinedCells)
{
  checkRemeshing<2>();
  checkRemeshing<3>();
}

/// Values go with their nodes to a rank that has these at other rows; nodes that it has not are lost.
TEST(NodalFieldTable, FollowsNodesToOtherRows)
{
  const Cells<2> whole;
  Cells<2> part = window(whole, 2, 5);
  part.tree.generation = 1;
  NodalFieldTable<2> table;
  table.add({{"kept", 1, "", ""}, OnRemesh::Keep, false, true});
  table.move(whole.nodes(), 0, {});
  fill(table, "kept", whole);
  table.move(part.nodes(), 1, {});
  for (int n = 0; n < part.size(); ++n)
    EXPECT_NEAR(table.scalar("kept")(n), linear(part.position(n)), 1e-12);
  EXPECT_EQ(static_cast<int>(table.lost("kept").size()), whole.size() - part.size());
}

TEST(NodalFieldTable, RefusesWhatIsNotThere)
{
  NodalFieldTable<2> table;
  table.add({{"two", 2, "m", ""}});
  table.move(Cells<2>().nodes(), 0, {});
  EXPECT_THROW(table.add({{"two", 1, "", ""}}), std::logic_error);
  EXPECT_THROW(table.scalar("two"), std::logic_error);
  EXPECT_THROW(table.scalar("three"), std::logic_error);
  EXPECT_EQ(table.real<2>("two").extent(1), 2u);
}

/// A checkpoint stores values by the identity of nodes, independent of their order.
TEST(NodalFieldTable, ComesBackFromACheckpoint)
{
  std::mt19937 engine(3);
  const auto make = [&](const Cells<2>& cells)
  {
    State<2> state;
    state.mesh.grid = cells.grid;
    state.mesh.tree = cells.tree;
    state.mesh.nodalFields.add({{"kept", 1, "", ""}});
    state.mesh.nodalFields.add({{"never used", 1, "", ""}});
    moveNodalFields(state);
    return state;
  };
  Cells<2> cells;
  cells.refine(3, engine);
  State<2> saved = make(cells), loaded = make(cells);
  fill(saved.mesh.nodalFields, "kept", cells);
  Record record;
  Archive to = Archive::saving(record), from = Archive::loading(record);
  archiveNodalFields(saved, to);
  archiveNodalFields(loaded, from);
  for (int n = 0; n < cells.size(); ++n)
    EXPECT_EQ(loaded.mesh.nodalFields.scalar("kept")(n), saved.mesh.nodalFields.scalar("kept")(n));
  Cells<2> others;
  State<2> coarse = make(others);
  EXPECT_THROW(archiveNodalFields(coarse, from), std::invalid_argument);
}

} // namespace Test
} // namespace Rhegma
