/// Stencils in refined cells as products of the axes are those that the leaves give one by one.

#include "transfer/LocalSpacing.hpp"
#include "transfer/TreeStencil.hpp"

#include "../grid/RandomTrees.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

namespace Rhegma
{
namespace Test
{

namespace
{

constexpr int trees = 200, boxesPerTree = 50;
/// Products and sums of a few dozen numbers of order 1 (weights) and 1/h of the smallest cells (slopes).
constexpr double roundOff = 1e-13;

/// Largest difference of weights, and of slopes times the spacing, over all nodes of two rows.
template <int D>
double difference(const StencilTable<D>& table, double spacing)
{
  std::map<int, std::array<double, D + 1>> left;
  for (const int row : {0, 1})
    for (int k = 0; k < table.count(row); ++k)
    {
      std::array<double, D + 1>& entry = left[table.node(row, k)];
      const double sign = row == 0 ? 1.0 : -1.0;
      entry[D] += sign * table.weight(row, k);
      for (int d = 0; d < D; ++d)
        entry[d] += sign * spacing * table.slope(row, k, d);
    }
  double worst = 0.0;
  for (const auto& entry : left)
    for (const double value : entry.second)
      worst = std::max(worst, std::fabs(value));
  return worst;
}

/// Largest number of entries of a node in row 0.
template <int D>
int mostTimes(const StencilTable<D>& table)
{
  std::map<int, int> times;
  int most = 0;
  for (int k = 0; k < table.count(0); ++k)
    most = std::max(most, ++times[table.node(0, k)]);
  return most;
}

template <int D, ShapeKind S>
void compare()
{
  const Grid<D> grid = lattice<D>();
  std::mt19937 engine(11);
  std::uniform_real_distribution<double> fraction(0.0, 1.0);
  StencilTable<D> table;
  table.reserve(2);
  int refined = 0;
  for (int t = 0; t < trees; ++t)
  {
    Tree<D> tree;
    buildTree(randomBranches(grid, 3, engine), tree);
    const TreeSight<D> sight(grid, tree);
    const TreeStencils<D, S> stencils(grid, tree, table);
    for (int b = 0; b < boxesPerTree; ++b)
    {
      Vector<D> x, half{};
      for (int d = 0; d < D; ++d)
        x[d] = grid.lower[d] + fraction(engine) * (grid.upper[d] - grid.lower[d]);
      // Up to half the edge of the leaf, as split particles have, and every fifth box a little more.
      const double most = (b % 5 == 0 ? 0.7 : 0.5) * sight.spacingAt(x);
      for (int d = 0; d < D && S == ShapeKind::Gimp; ++d)
        half[d] = most * (0.01 + 0.99 * fraction(engine));
      // A box that reaches into much smaller cells than its own, whose particle would be split, may not fit.
      const bool fits = writeTreeStencil(sight, table, 1, x, half);
      ASSERT_EQ(stencils.write(0, x, half), fits);
      refined += fits && sight.leafAt(x).level > 0 ? 1 : 0;
      ASSERT_LT(difference(table, std::ldexp(grid.spacing, -tree.deepest)), roundOff);
      ASSERT_LE(mostTimes(table), 1);
    }
  }
  EXPECT_GT(refined, trees * boxesPerTree / 10);
}

/// Boxes that begin and end on faces of leaves, on middles of leaves or a rounding next to them.
template <int D>
void compareOnFaces()
{
  const Grid<D> grid = lattice<D>();
  std::mt19937 engine(13);
  std::uniform_real_distribution<double> fraction(0.0, 1.0);
  StencilTable<D> table;
  table.reserve(2);
  int onFaces = 0;
  for (int t = 0; t < trees; ++t)
  {
    Tree<D> tree;
    buildTree(randomBranches(grid, 3, engine), tree);
    const TreeSight<D> sight(grid, tree);
    const TreeStencils<D, ShapeKind::Gimp> stencils(grid, tree, table);
    for (int b = 0; b < boxesPerTree; ++b)
    {
      Vector<D> x, half;
      for (int d = 0; d < D; ++d)
        x[d] = grid.lower[d] + (0.1 + 0.8 * fraction(engine)) * (grid.upper[d] - grid.lower[d]);
      const auto leaf = sight.leafAt(x);
      bool bothFaces = false;
      for (int d = 0; d < D; ++d)
      {
        // From a face of the leaf, or its middle, to its middle or the other face.
        const int from = static_cast<int>(engine() % 2),
                  to = from + 1 + static_cast<int>(engine() % (2 - from));
        const double begin = leaf.corner[d] + 0.5 * from * leaf.edge,
                     end = leaf.corner[d] + 0.5 * to * leaf.edge;
        x[d] = grid.nodePosition(0)[d] + 0.5 * (begin + end) * grid.spacing;
        half[d] = 0.5 * (end - begin) * grid.spacing;
        const int adjacent = static_cast<int>(engine() % 3) - 1;
        if (adjacent != 0)
          half[d] = std::nextafter(half[d], adjacent > 0 ? 1.0 : 0.0);
        bothFaces = bothFaces || (from == 0 && to == 2);
      }
      onFaces += bothFaces ? 1 : 0;
      const bool fits = writeTreeStencil(sight, table, 1, x, half);
      ASSERT_TRUE(fits);
      ASSERT_TRUE(stencils.write(0, x, half));
      ASSERT_LT(difference(table, std::ldexp(grid.spacing, -tree.deepest)), roundOff);
      double sum = 0.0;
      for (int k = 0; k < table.count(0); ++k)
        sum += table.weight(0, k);
      ASSERT_NEAR(sum, 1.0, roundOff);
      // No node is reached but corners of the leaf and their masters, of which a corner has 2^(D-1) at most;
      // what lies beyond the leaf by a rounding has no weight but a rounding.
      int reached = 0;
      for (int k = 0; k < table.count(0); ++k)
        reached += std::fabs(table.weight(0, k)) > roundOff ? 1 : 0;
      ASSERT_LE(reached, (1 << D) * (1 << (D - 1)));
    }
  }
  EXPECT_GT(onFaces, trees * boxesPerTree / 10);
}

} // namespace

TEST(TreeStencil, BoxesThatEndOnFacesOfLeaves)
{
  compareOnFaces<2>();
  compareOnFaces<3>();
}

TEST(TreeStencil, ProductsInTwoDimensions)
{
  compare<2, ShapeKind::Linear>();
  compare<2, ShapeKind::Gimp>();
}

TEST(TreeStencil, ProductsInThreeDimensions)
{
  compare<3, ShapeKind::Linear>();
  compare<3, ShapeKind::Gimp>();
}

/// After an unstable step a front may be anywhere, or nowhere.
TEST(LocalSpacing, OutsideOfTheDomainCellsAreTheLargest)
{
  State<2> state;
  state.mesh.grid = lattice<2>();
  std::mt19937 engine(3);
  do
    buildTree(randomBranches(state.mesh.grid, 3, engine), state.mesh.tree);
  while (!state.mesh.tree.refined());
  const Vector<2> middle = 0.5 * (state.mesh.grid.lower + state.mesh.grid.upper);
  EXPECT_LE(spacingAt(state, middle), state.mesh.grid.spacing);
  for (const double far : {-1e3, 1e3, 1e30, -1e300, double(NAN), double(INFINITY)})
    for (int d = 0; d < 2; ++d)
    {
      Vector<2> x = middle;
      x[d] = far;
      EXPECT_EQ(spacingAt(state, x), state.mesh.grid.spacing) << far;
    }
}

} // namespace Test
} // namespace Rhegma
