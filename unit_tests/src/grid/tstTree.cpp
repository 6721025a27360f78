/// Random balanced trees: shape functions are complete, masters hang nowhere, numbers do not depend
/// on the order of refinement.

#include "RandomTrees.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace Rhegma
{
namespace Test
{

namespace
{

constexpr int trees = 1000;
constexpr int boxesPerTree = 20;
/// Sums of up to 4 leaves' corners in double precision, weights of order 1, slopes of order 1/h.
constexpr double roundOff = 1e-12;

template <int D>
Vector<D> anywhere(const Grid<D>& grid, std::mt19937& engine)
{
  std::uniform_real_distribution<double> fraction(0.0, 1.0);
  Vector<D> x;
  for (int d = 0; d < D; ++d)
    x[d] = grid.lower[d] + fraction(engine) * (grid.upper[d] - grid.lower[d]);
  return x;
}

/// How far a stencil is from the value and the slope of 1, x, y and z. \param refined is set where it has
/// nodes of refined cells
template <int D>
double incompleteness(const TreeSight<D>& sight, const NodePositions<D>& positions, const Vector<D>& x,
                      const Vector<D>& half, bool& refined)
{
  double sum = -1.0, slopes[D] = {}, value[D] = {}, gradient[D][D] = {};
  sight.forEachNode(x, half,
                    [&](int node, double weight, const double(&slope)[D])
                    {
                      const Vector<D> position = positions(node);
                      refined = refined || node >= positions.grid.numNodes;
                      sum += weight;
                      for (int i = 0; i < D; ++i)
                      {
                        slopes[i] += slope[i];
                        value[i] += weight * (position[i] - x[i]);
                        for (int j = 0; j < D; ++j)
                          gradient[i][j] += slope[j] * (position[i] - x[i]);
                      }
                    });
  double worst = std::fabs(sum);
  for (int i = 0; i < D; ++i)
  {
    worst = std::max({worst, std::fabs(slopes[i]) * sight.grid.spacing, std::fabs(value[i])});
    for (int j = 0; j < D; ++j)
      worst = std::max(worst, std::fabs(gradient[i][j] - (i == j ? 1.0 : 0.0)));
  }
  return worst;
}

template <int D>
void checkCompleteness()
{
  const Grid<D> grid = lattice<D>();
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> width(0.0, 0.6 * grid.spacing);
  double worst = 0.0;
  int refined = 0;
  for (int t = 0; t < trees; ++t)
  {
    Tree<D> tree;
    buildTree(randomBranches(grid, D == 2 ? 4 : 3, engine), tree);
    const TreeSight<D> sight(grid, tree);
    const NodePositions<D> positions{grid, tree.finePosition};
    for (int b = 0; b < boxesPerTree; ++b)
    {
      const Vector<D> x = anywhere(grid, engine);
      Vector<D> half{};
      for (int d = 0; d < D && b % 4 != 0; ++d) // every fourth is a point
        half[d] = width(engine);
      bool inRefined = false;
      worst = std::max(worst, incompleteness(sight, positions, x, half, inRefined));
      refined += inRefined ? 1 : 0;
    }
  }
  EXPECT_GT(refined, trees);
  EXPECT_LT(worst, roundOff);
}

/// By the number of a node: as how many masters the corners of leaves at its position are seen.
template <int D>
void checkMasters()
{
  const Grid<D> grid = lattice<D>();
  std::mt19937 engine(5);
  int hanging = 0, chains = 0;
  double wrongPosition = 0.0;
  for (int t = 0; t < trees; ++t)
  {
    Tree<D> tree;
    buildTree(randomBranches(grid, D == 2 ? 4 : 3, engine), tree);
    const NodePositions<D> positions{grid, tree.finePosition};
    // Positions in units of a cell of 1/2^8 of the lattice's, which all corners are multiples of.
    std::map<std::array<long, D>, int> masters;
    const auto unit = [&](const Vector<D>& x)
    {
      std::array<long, D> at;
      for (int d = 0; d < D; ++d)
        at[d] = std::lround(256.0 * grid.inCells(x[d], d));
      return at;
    };
    for (int l = 0; l < static_cast<int>(tree.leafLevel.extent(0)); ++l)
      for (int k = 0; k < Tree<D>::corners; ++k)
      {
        Vector<D> x, mean{};
        for (int d = 0; d < D; ++d)
          x[d] = tree.leafCorner(l, d) + ((k >> d) & 1) * std::ldexp(grid.spacing, -tree.leafLevel(l));
        const int count = tree.masterCount(l, k);
        for (int m = 0; m < count; ++m)
          mean = mean + (1.0 / count) * positions(tree.master(l, k, m));
        wrongPosition = std::max(wrongPosition, norm(mean - x));
        const auto found = masters.emplace(unit(x), count).first;
        EXPECT_EQ(found->second, count); // all leaves around a position see it alike
        hanging += count > 1 ? 1 : 0;
      }
    for (int l = 0; l < static_cast<int>(tree.leafLevel.extent(0)); ++l)
      for (int k = 0; k < Tree<D>::corners; ++k)
        for (int m = 0; m < tree.masterCount(l, k); ++m)
        {
          const auto found = masters.find(unit(positions(tree.master(l, k, m))));
          chains += found != masters.end() && found->second > 1 ? 1 : 0;
        }
  }
  EXPECT_GT(hanging, 10 * trees);
  EXPECT_EQ(chains, 0);
  EXPECT_LT(wrongPosition, roundOff);
}

/// Fractions of all nodes add up to the cells, and each is the integral of the node's function.
template <int D>
void checkNodeVolumes()
{
  const Grid<D> grid = lattice<D>();
  std::mt19937 engine(9);
  double cells = 1.0;
  for (int d = 0; d < D; ++d)
    cells *= grid.cells[d];
  for (int t = 0; t < 20; ++t)
  {
    Tree<D> tree;
    buildTree(randomBranches(grid, D == 2 ? 4 : 3, engine), tree);
    double sum = 0.0, least = 1.0;
    for (int n = 0; n < static_cast<int>(tree.nodeVolume.extent(0)); ++n)
    {
      sum += tree.nodeVolume(n);
      least = std::min(least, tree.nodeVolume(n));
    }
    // Nodes on the rim of the lattice have whole volumes: more than the cells, by what is beyond.
    double all = 1.0;
    for (int d = 0; d < D; ++d)
      all *= grid.cells[d] + 1;
    EXPECT_NEAR(sum, all, 1e-9 * all);
    EXPECT_GT(all, cells);
    EXPECT_GT(least, 0.0);
  }
}

} // namespace

TEST(Tree, completeIn2D) { checkCompleteness<2>(); }
TEST(Tree, completeIn3D) { checkCompleteness<3>(); }
TEST(Tree, mastersHangNowhereIn2D) { checkMasters<2>(); }
TEST(Tree, mastersHangNowhereIn3D) { checkMasters<3>(); }
TEST(Tree, nodeVolumesFillTheCells)
{
  checkNodeVolumes<2>();
  checkNodeVolumes<3>();
}

/// The order in which cells were refined leaves no trace.
TEST(Tree, numbersDoNotDependOnHistory)
{
  const Grid<2> grid = lattice<2>();
  Branches<2> once(grid), again(grid);
  once.refine(2, {21, 17});
  once.refine(1, {9, 12});
  again.refine(0, {5, 4});
  again.refine(1, {9, 12});
  again.refine(2, {21, 17});
  again.refine(0, {4, 6});
  once.balance();
  again.balance();
  Tree<2> first, second;
  buildTree(once, first);
  buildTree(again, second);
  ASSERT_TRUE(once == again);
  ASSERT_EQ(first.numFine, second.numFine);
  ASSERT_GT(first.numFine, 0);
  for (int n = 0; n < first.numFine; ++n)
    for (int d = 0; d < 2; ++d)
      EXPECT_EQ(first.finePosition(n, d), second.finePosition(n, d));
}

TEST(Tree, goneWhenNothingIsRefined)
{
  const Grid<2> grid = lattice<2>();
  Tree<2> tree;
  Branches<2> some(grid);
  some.refine(0, {5, 5});
  buildTree(some, tree);
  EXPECT_TRUE(tree.refined());
  buildTree(Branches<2>(grid), tree);
  EXPECT_FALSE(tree.refined());
  EXPECT_EQ(tree.generation, 2);
  EXPECT_EQ(tree.numFine, 0);
}

} // namespace Test
} // namespace Rhegma
