#include "surface/GrowingPolyline.hpp"

#include <gtest/gtest.h>

using namespace Rhegma;
using namespace Rhegma::surface;

namespace
{

/// Three points along x, one unit apart, and a front at each end.
struct Line
{
  GrowingPolyline mesh;
  FrontLines<2> first{1}, last{1};

  Line()
  {
    for (int v = 0; v < 3; ++v)
    {
      mesh.vertices.push_back({double(v), 0.0});
      mesh.faces.push_back({Vector<2>{double(v), 0.0}, {double(v), 0.0}});
    }
    mesh.prepare();
    last[0].vertex = 2;
  }
};

} // namespace

/// Segments are added at the end where the front is. Once tidied, vertices are in their order.
TEST(GrowingPolyline, GrowsAtBothEnds)
{
  Line line;
  EXPECT_EQ(line.mesh.advance(line.first, 0, {-0.5, 0.0}, 0.5), 0.5);
  EXPECT_EQ(line.mesh.advance(line.last, 0, {2.0, 0.25}, 0.25), 0.25);
  EXPECT_TRUE(line.mesh.isFirst(line.first[0].vertex));
  EXPECT_FALSE(line.mesh.isFirst(line.last[0].vertex));
  line.mesh.tidy({&line.first, &line.last});
  EXPECT_EQ(line.first[0].vertex, 0);
  EXPECT_EQ(line.last[0].vertex, 4);
  ASSERT_EQ(line.mesh.vertices.size(), 5u);
  EXPECT_EQ(line.mesh.vertices[0][0], -0.5);
  EXPECT_EQ(line.mesh.vertices[4][1], 0.25);
  EXPECT_EQ(line.mesh.faces[4][1][1], 0.25);
}

/// An end without a front breaks the surface, or has joined another crack.
TEST(GrowingPolyline, KnowsWhatLiesBeyondItsEnds)
{
  Line line;
  line.last.clear();
  const CrackMesh<2> mesh = line.mesh.mesh({&line.first, &line.last});
  EXPECT_EQ(mesh.beyond.front()[1], facet::front);
  EXPECT_EQ(mesh.beyond.back()[0], facet::surfaceBreaking);
  line.mesh.joined[1] = true;
  EXPECT_EQ(line.mesh.mesh({&line.first}).beyond.back()[0], facet::joined);
}

/// The opening is linear between vertices, and grows as a root up to the first one behind the end.
TEST(GrowingPolyline, IsOpenBehindAnEnd)
{
  Line line;
  line.mesh.faces[1][1] = {1.0, 0.2};
  line.mesh.faces[0][1] = {0.0, 0.6};
  EXPECT_DOUBLE_EQ(line.mesh.openingBehind(2, 0.25), 0.1); // 0.2 sqrt(0.25)
  EXPECT_DOUBLE_EQ(line.mesh.openingBehind(2, 1.5), 0.4);
  EXPECT_DOUBLE_EQ(line.mesh.openingBehind(2, 5.0), 0.6);
}
