#include "grid/StencilTable.hpp"
#include "transfer/Box.hpp"

#include <gtest/gtest.h>

#include <array>

using namespace Rhegma;

namespace
{

/// Half widths of a box with edges 2 and 1 along x and y under F (row by row).
std::array<double, 2> boxUnder(const double (&F)[4], double largest)
{
  const View<double* [2][2]> axes("rhegma::axes", 1);
  axes(0, 0, 0) = axes(0, 1, 1) = 1.0;
  const double edge[2] = {2.0, 1.0};
  std::array<double, 2> half{};
  updateBox<2>(axes, 0, edge, F, largest, half.data());
  return half;
}

} // namespace

TEST(Box, FollowsStretchAndQuarterTurns)
{
  const auto still = boxUnder({1.0, 0.0, 0.0, 1.0}, 9.0);
  EXPECT_EQ(still[0], 1.0);
  EXPECT_EQ(still[1], 0.5);
  const auto stretched = boxUnder({1.5, 0.0, 0.0, 0.5}, 9.0);
  EXPECT_EQ(stretched[0], 1.5);
  EXPECT_EQ(stretched[1], 0.25);
  const auto turned = boxUnder({0.0, -1.0, 1.0, 0.0}, 9.0);
  EXPECT_EQ(turned[0], 0.5);
  EXPECT_EQ(turned[1], 1.0);
}

/// Second moments: of a box turned by 45 degrees both are the mean of the squares.
TEST(Box, HasTheSecondMomentsOfATurnedBox)
{
  const double c = std::sqrt(0.5);
  const auto half = boxUnder({c, -c, c, c}, 9.0);
  EXPECT_NEAR(half[0], std::sqrt(0.5 * (1.0 + 0.25)), 1e-15);
  EXPECT_NEAR(half[1], std::sqrt(0.5 * (1.0 + 0.25)), 1e-15);
}

TEST(Box, IsNotWiderThanAllowed)
{
  const auto half = boxUnder({1.0, 0.0, 0.0, 1.0}, 0.75);
  EXPECT_EQ(half[0], 0.75);
  EXPECT_EQ(half[1], 0.5);
}

/// Weights of the stored stencil are products along the axes and give x back; slopes give the unit matrix.
template <ShapeKind S>
void checkStored()
{
  const Grid<3> grid = makeGrid<3>({{0.0, 0.0, 0.0}}, {{3.0, 2.0, 1.0}}, 0.25);
  StencilTable<3> table;
  table.reserve(2);
  EXPECT_GE(table.size(), 2);
  const Vector<3> x{{1.3, 0.77, 0.41}}, half{{0.06, 0.11, 0.125}};
  writeStencil<3, S>(grid, table, 1, x, half);
  constexpr int N = nodesPerAxis<S>;
  ASSERT_EQ(table.count(1), N * N * N);
  double one = 0.0, position[3] = {}, slope[3][3] = {};
  for (int k = 0; k < table.count(1); ++k)
  {
    const Vector<3> node = grid.nodePosition(table.node(1, k));
    one += table.weight(1, k);
    for (int d = 0; d < 3; ++d)
    {
      position[d] += table.weight(1, k) * node[d];
      for (int e = 0; e < 3; ++e)
        slope[d][e] += table.slope(1, k, d) * node[e];
    }
  }
  EXPECT_NEAR(one, 1.0, 1e-14);
  for (int d = 0; d < 3; ++d)
  {
    EXPECT_NEAR(position[d], x[d], 1e-14);
    for (int e = 0; e < 3; ++e)
      EXPECT_NEAR(slope[d][e], d == e ? 1.0 : 0.0, 1e-13);
  }
}

TEST(StencilTable, StoresCompleteFunctions)
{
  checkStored<ShapeKind::Linear>();
  checkStored<ShapeKind::Gimp>();
}

TEST(StencilTable, GrowsOnly)
{
  StencilTable<2> table;
  table.reserve(100);
  const int capacity = table.size();
  EXPECT_GE(capacity, 100);
  table.reserve(10);
  EXPECT_EQ(table.size(), capacity);
}
