#include "surface/FrontPieces.hpp"
#include "surface/Polyline.hpp"

#include <gtest/gtest.h>

using namespace Rhegma;
using namespace Rhegma::surface;

namespace
{

using Points = std::vector<Vector<2>>;

bool isBelowTwo(const Vector<2>& x) { return x[0] > 0.25 && x[0] < 2.0; }

} // namespace

/// Each segment by itself: 3 of a length of 1 for 3.0, to rounding, and 2 of 0.75 for 1.5.
TEST(Polyline, IsSplitIntoEqualPieces)
{
  const Points fine = splitSegments({{0.0, 0.0}, {3.0, 0.0}, {3.0, 1.5}}, 1.0 - 1e-12);
  ASSERT_EQ(fine.size(), 6u);
  EXPECT_DOUBLE_EQ(fine[1][0], 1.0);
  EXPECT_EQ(fine[3][0], 3.0);
  EXPECT_DOUBLE_EQ(fine[4][1], 0.75);
}

/// Segments that cross, touch or turn back; those of a bend do not, nor do ones that are close.
TEST(Polyline, FindsTheFirstCrossing)
{
  const std::array<int, 2> none{-1, -1}, crossing{0, 2}, turning{0, 1};
  EXPECT_EQ(firstCrossing({{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {1.0, 0.1}}, 1e-6), none);
  EXPECT_EQ(firstCrossing({{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {1.0, -1.0}}, 1e-6), crossing);
  EXPECT_EQ(firstCrossing({{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {1.0, 0.0}}, 1e-6), crossing);
  EXPECT_EQ(firstCrossing({{0.0, 0.0}, {2.0, 0.0}, {1.0, 0.0}}, 1e-6), turning);
}

/// Both ends are cut to within the resolution, a bend inside stays, one outside is removed.
TEST(Polyline, IsClippedAtItsEnds)
{
  const Points kept = clipEnds({{0.0, 0.0}, {0.1, 0.0}, {1.0, 0.0}, {3.0, 0.0}}, isBelowTwo, 0.01);
  ASSERT_EQ(kept.size(), 3u);
  EXPECT_NEAR(kept[0][0], 0.25, 0.0101);
  EXPECT_GT(kept[0][0], 0.25);
  EXPECT_EQ(kept[1][0], 1.0);
  EXPECT_NEAR(kept[2][0], 2.0, 0.0101);
  EXPECT_LT(kept[2][0], 2.0);
  EXPECT_TRUE(clipEnds({{3.0, 0.0}, {4.0, 0.0}}, isBelowTwo, 0.01).empty());
}

/// A region that extends for a quarter of a cell, or for all of it.
TEST(Polyline, KnowsWhetherARegionExtends)
{
  EXPECT_TRUE(extendsBeyond<2>(isBelowTwo, {0.9, 0.0}, {3.0, 0.0}, 1.0));
  EXPECT_FALSE(extendsBeyond<2>(isBelowTwo, {1.1, 0.0}, {3.0, 0.0}, 1.0));
}

/// Facet 0 of a segment is its second end. Fronts come first end first, each with its own vertex.
TEST(Polyline, HasItsEndsInItsMesh)
{
  const Points line{{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}};
  const CrackMesh<2> mesh = polylineMesh(line, {facet::front, facet::front});
  ASSERT_EQ(mesh.simplices.size(), 2u);
  EXPECT_EQ(mesh.beyond[0][0], 1);
  EXPECT_EQ(mesh.beyond[1][1], 0);
  const auto fronts = frontsOf(mesh);
  ASSERT_EQ(fronts.size(), 2u);
  EXPECT_EQ(middleVertex(mesh, fronts[0]), 0);
  EXPECT_EQ(middleVertex(mesh, fronts[1]), 2);
  EXPECT_TRUE(frontsOf(polylineMesh(line, {facet::surfaceBreaking, facet::joined})).empty());
}
