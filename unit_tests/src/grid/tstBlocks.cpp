#include "grid/Blocks.hpp"
#include "grid/ShapeFunctions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

using namespace Rhegma;

namespace
{

constexpr int count = 5000;

/// Random particles with their number as id, and again at the positions of the first ten, so that cells are
/// shared.
template <int D>
FieldTable scattered(const Grid<D>& grid)
{
  FieldTable table;
  table.add({fields::position, D, "m", ""});
  table.add({fields::id, 1, "", "", true});
  table.resize(count);
  const auto position = table.real<D>(fields::position);
  const auto id = table.integer(fields::id);
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int p = 0; p < count; ++p)
  {
    id(p) = p;
    for (int d = 0; d < D; ++d)
      position(p, d) = p >= count - 10 ? position(p - (count - 10), d)
                                       : grid.lower[d] + part(engine) * (grid.upper[d] - grid.lower[d]);
  }
  return table;
}

template <int D>
struct Sorted
{
  Grid<D> grid;
  FieldTable table;
  Blocks<D> blocks;
  View<int*> active;

  Sorted()
  {
    Vector<D> lower, upper;
    for (int d = 0; d < D; ++d)
    {
      lower[d] = -1.0;
      upper[d] = D == 2 ? 5.0 - d : 2.0 - 0.5 * d;
    }
    grid = makeGrid<D>(lower, upper, 0.125);
    table = scattered(grid);
    sortParticles(grid, table, blocks, active);
  }

  int cellAlong(int p, int axis) const
  {
    return static_cast<int>(grid.inCells(table.real<D>(fields::position)(p, axis), axis));
  }
};

/// Every particle lies in its block, once, and the blocks are in the order of their colours.
template <int D>
void checkOrder()
{
  const Sorted<D> s;
  std::set<int> seen;
  const auto id = s.table.integer(fields::id);
  ASSERT_EQ(s.blocks.first(0), 0);
  ASSERT_EQ(s.blocks.first(s.blocks.numBlocks), count);
  ASSERT_EQ(s.blocks.colourStart[Blocks<D>::colours], s.blocks.numBlocks);
  for (int b = 0; b < s.blocks.numBlocks; ++b)
    for (int p = s.blocks.first(b); p < s.blocks.first(b + 1); ++p)
    {
      EXPECT_TRUE(seen.insert(id(p)).second);
      for (int a = 0; a < Blocks<D>::axes; ++a)
      {
        const int cell = s.cellAlong(p, s.grid.axisOrder[a]);
        EXPECT_GE(cell, s.blocks.corner(b, a));
        EXPECT_LT(cell, s.blocks.corner(b, a) + Blocks<D>::edge);
      }
    }
  EXPECT_EQ(static_cast<int>(seen.size()), count);
}

/// Blocks of one colour are a whole block apart along an axis.
template <int D>
void checkColours()
{
  const Sorted<D> s;
  const int* start = s.blocks.colourStart;
  EXPECT_GT(s.blocks.numBlocks, Blocks<D>::colours);
  for (int colour = 0; colour < Blocks<D>::colours; ++colour)
    for (int a = start[colour]; a < start[colour + 1]; ++a)
      for (int b = a + 1; b < start[colour + 1]; ++b)
      {
        int apart = 0;
        for (int axis = 0; axis < Blocks<D>::axes; ++axis)
          apart = std::max(apart, std::abs(s.blocks.corner(a, axis) - s.blocks.corner(b, axis)));
        EXPECT_GE(apart, 2 * Blocks<D>::edge);
      }
}

} // namespace

TEST(Blocks, HoldEveryParticleOnce)
{
  checkOrder<2>();
  checkOrder<3>();
}

TEST(Blocks, OfOneColourAreApart)
{
  checkColours<2>();
  checkColours<3>();
}

TEST(Blocks, KeepTheOrderInsideACell)
{
  const Sorted<2> s;
  const auto id = s.table.integer(fields::id);
  int shared = 0;
  for (int p = 1; p < count; ++p)
    if (s.cellAlong(p, 0) == s.cellAlong(p - 1, 0) && s.cellAlong(p, 1) == s.cellAlong(p - 1, 1))
    {
      EXPECT_LT(id(p - 1), id(p));
      ++shared;
    }
  EXPECT_GE(shared, 10);
}

TEST(Blocks, AreCutIntoBundles)
{
  const Sorted<2> s;
  ASSERT_EQ(s.blocks.bundleFirst(s.blocks.numBundles), count);
  for (int k = 0; k < s.blocks.numBundles; ++k)
  {
    const int begin = s.blocks.bundleFirst(k), end = s.blocks.bundleFirst(k + 1);
    EXPECT_GT(end, begin);
    EXPECT_LE(end - begin, lanes);
    const int b = s.blocks.bundleBlock(k);
    EXPECT_GE(begin, s.blocks.first(b));
    EXPECT_LE(end, s.blocks.first(b + 1));
  }
}

/// Also after a drift of a cell, which the blocks allow.
TEST(Blocks, ListAllNodesThatParticlesReach)
{
  const Sorted<2> s;
  std::set<int> active;
  for (std::size_t i = 0; i < s.active.extent(0); ++i)
    EXPECT_TRUE(active.insert(s.active(i)).second);
  const auto position = s.table.real<2>(fields::position);
  for (int p = 0; p < count; ++p)
    for (const double drift : {-1.0, 0.0, 1.0})
    {
      const auto x = gimpStencil(s.grid.inCells(position(p, 0), 0) + drift, 0.5);
      const auto y = gimpStencil(s.grid.inCells(position(p, 1), 1) + drift, 0.5);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          ASSERT_EQ(active.count((x.first + i) * s.grid.stride[0] + (y.first + j) * s.grid.stride[1]), 1u);
    }
}

TEST(Blocks, RunABodyOnEveryParticle)
{
  const Sorted<3> s;
  const View<int*> visits("rhegma::visits", count);
  forEachBlock("rhegma::countVisits", s.blocks,
               [=](int begin, int end)
               {
                 for (int p = begin; p < end; ++p)
                   ++visits(p);
               });
  for (int p = 0; p < count; ++p)
    ASSERT_EQ(visits(p), 1);
}
