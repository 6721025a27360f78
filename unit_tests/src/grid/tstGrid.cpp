#include "grid/Grid.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

using namespace Rhegma;

TEST(Grid, AddsAMarginToTheDomain)
{
  const Grid<2> grid = makeGrid<2>({{1.0, -2.0}}, {{2.0, -1.5}}, 0.25);
  EXPECT_EQ(grid.cells[0], 4 + 2 * gridMargin);
  EXPECT_EQ(grid.cells[1], 2 + 2 * gridMargin);
  EXPECT_EQ(grid.numNodes, 13 * 11);
  const Vector<2> first = grid.nodePosition(0);
  EXPECT_EQ(first[0], 1.0 - gridMargin * 0.25);
  EXPECT_EQ(first[1], -2.0 - gridMargin * 0.25);
  EXPECT_EQ(grid.inCells(1.5, 0), gridMargin + 2.0);
}

/// 0.3 / 0.1 is a little less than 3 in doubles, and 0.7 / 0.1 a little more than 7 would be one cell too
/// many.
TEST(Grid, CountsWholeCellsDespiteRoundOff)
{
  for (const double length : {0.3, 0.7, 1.1, 12.9})
  {
    const Grid<2> grid = makeGrid<2>({{0.1, 0.0}}, {{0.1 + length, 0.1}}, 0.1);
    EXPECT_EQ(grid.cells[0], std::lround(length / 0.1) + 2 * gridMargin) << length;
  }
}

TEST(Grid, ReachesBeyondADomainOfBrokenCells)
{
  const Grid<2> grid = makeGrid<2>({{0.0, 0.0}}, {{1.01, 1.0}}, 0.5);
  EXPECT_EQ(grid.cells[0], 3 + 2 * gridMargin);
  EXPECT_EQ(grid.cells[1], 2 + 2 * gridMargin);
  EXPECT_FALSE(grid.inside({{1.02, 0.5}})) << "the domain itself does not grow";
  EXPECT_TRUE(grid.inside({{1.01, 1.0}}));
  EXPECT_TRUE(grid.inside({{0.0, 0.0}}));
  EXPECT_FALSE(grid.inside({{-1e-9, 0.5}}));
}

TEST(Grid, NumbersAlongTheShortestAxisFirst)
{
  const Grid<3> grid = makeGrid<3>({{0.0, 0.0, 0.0}}, {{2.0, 5.0, 3.0}}, 1.0);
  EXPECT_EQ(grid.axisOrder[0], 1);
  EXPECT_EQ(grid.axisOrder[1], 2);
  EXPECT_EQ(grid.axisOrder[2], 0);
  EXPECT_EQ(grid.stride[0], 1);
  EXPECT_EQ(grid.stride[2], 11);
  EXPECT_EQ(grid.stride[1], 11 * 12);
  EXPECT_EQ(grid.numNodes, 11 * 12 * 14);
}

TEST(Grid, FindsItsNodesAgain)
{
  const Grid<3> grid = makeGrid<3>({{-1.0, 0.0, 0.5}}, {{1.0, 3.0, 1.5}}, 0.5);
  for (int n = 0; n < grid.numNodes; ++n)
  {
    int at[3];
    grid.nodeCoordinates(n, at);
    ASSERT_EQ(grid.nodeIndex(at), n);
    const Vector<3> x = grid.nodePosition(n);
    for (int d = 0; d < 3; ++d)
    {
      ASSERT_GE(at[d], 0);
      ASSERT_LE(at[d], grid.cells[d]);
      ASSERT_EQ(grid.inCells(x[d], d), at[d]); // 0.5 and its multiples are exact
    }
  }
}

TEST(Grid, RefusesMoreNodesThanAnIntCanNumber)
{
  EXPECT_THROW(makeGrid<3>({{0.0, 0.0, 0.0}}, {{1.0, 1.0, 1.0}}, 1e-3), std::invalid_argument);
  EXPECT_THROW(makeGrid<2>({{0.0, 0.0}}, {{1.0, 1.0}}, 1e-12), std::invalid_argument);
}
