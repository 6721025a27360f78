#include "surface/NearestOnSimplex.hpp"
#include "surface/PlanarPolygon.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace Rhegma;
using namespace Rhegma::surface;

TEST(NearestOnSimplex, IsInsideOrAnEndOfASegment)
{
  const Vector<2> corner[2] = {{0.0, 0.0}, {4.0, 0.0}};
  const Foot<2> inside = footOn(corner, {1.0, 3.0}), before = footOn(corner, {-3.0, 4.0}),
                after = footOn(corner, {7.0, -4.0});
  EXPECT_EQ(inside.vertex, -1);
  EXPECT_DOUBLE_EQ(inside.weight[1], 0.25);
  EXPECT_EQ(before.vertex, 0);
  EXPECT_EQ(after.vertex, 1);
  EXPECT_DOUBLE_EQ(distanceToSimplex(corner, Vector<2>{1.0, 3.0}), 3.0);
  EXPECT_DOUBLE_EQ(distanceToSimplex(corner, Vector<2>{-3.0, 4.0}), 5.0);
  EXPECT_DOUBLE_EQ(distanceToSegment<2>({7.0, -4.0}, corner[0], corner[1]), 5.0);
}

/// The seven regions of a triangle's plane: inside, three edges, three corners.
TEST(NearestOnSimplex, HasSevenRegionsOnATriangle)
{
  const Vector<3> corner[3] = {{0.0, 0.0, 0.0}, {4.0, 0.0, 0.0}, {0.0, 4.0, 0.0}};
  struct Case
  {
    Vector<3> x;
    int vertex, facet;
    double distance;
  };
  for (const Case& c : {Case{{1.0, 1.0, 2.0}, -1, -1, 2.0}, Case{{1.0, -3.0, 4.0}, -1, 2, 5.0},
                        Case{{-3.0, 1.0, 4.0}, -1, 1, 5.0}, Case{{3.0, 3.0, 0.0}, -1, 0, std::sqrt(2.0)},
                        Case{{-1.0, -2.0, 2.0}, 0, -1, 3.0}, Case{{6.0, -1.0, 2.0}, 1, -1, 3.0},
                        Case{{-1.0, 6.0, 2.0}, 2, -1, 3.0}})
  {
    const Foot<3> foot = footOn(corner, c.x);
    EXPECT_EQ(foot.vertex, c.vertex);
    EXPECT_EQ(foot.facet, c.facet);
    EXPECT_NEAR(foot.weight[0] + foot.weight[1] + foot.weight[2], 1.0, 1e-15);
    EXPECT_NEAR(distanceToSimplex(corner, c.x), c.distance, 1e-14);
  }
}

/// A 3 x 2 rectangle at z = 5, seen anticlockwise from above: its axes run along its first edge and across.
TEST(PlanarPolygon, HasAPlane)
{
  double area = 0.0;
  const surface::Plane plane =
      planeOf({{1.0, 1.0, 5.0}, {1.0, 4.0, 5.0}, {-1.0, 4.0, 5.0}, {-1.0, 1.0, 5.0}}, area);
  EXPECT_DOUBLE_EQ(area, 6.0);
  EXPECT_DOUBLE_EQ(plane.normal[2], 1.0);
  EXPECT_DOUBLE_EQ(plane.a[1], 1.0);
  EXPECT_DOUBLE_EQ(plane.b[0], -1.0);
  const Vector<3> x{0.5, 3.0, 5.0};
  EXPECT_NEAR(norm(plane.in3D(plane.inPlane(x)) - x), 0.0, 1e-15);
  EXPECT_NEAR(plane.inPlane(x)[0], 0.5, 1e-15);
}

TEST(PlanarPolygon, FindsItsNearestEdge)
{
  const std::vector<Vector<2>> square{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
  EXPECT_EQ(nearestEdge(square, {0.5, 0.1}, 0.2), 0);
  EXPECT_EQ(nearestEdge(square, {0.95, 0.5}, 0.2), 1);
  EXPECT_EQ(nearestEdge(square, {-0.1, 0.5}, 0.2), 3);
  EXPECT_EQ(nearestEdge(square, {0.5, 0.5}, 0.2), -1);
}

/// The polygon has the area of the ellipse.
TEST(PlanarPolygon, HasTheAreaOfItsEllipse)
{
  const std::vector<Vector<2>> outline = ellipseOutline({3.0, 2.0}, 12);
  double area = 0.0;
  for (std::size_t k = 0; k < outline.size(); ++k)
  {
    const Vector<2>&a = outline[k], &b = outline[(k + 1) % outline.size()];
    area += 0.5 * (a[0] * b[1] - b[0] * a[1]);
  }
  EXPECT_NEAR(area, std::acos(-1.0) * 6.0, 1e-12);
}
