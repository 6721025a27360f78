#include "surface/Polyline.hpp"
#include "surface/Returns.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace Rhegma;
using namespace Rhegma::surface;

namespace
{

CrackMesh<2> lineOf(const std::vector<Vector<2>>& points)
{
  return polylineMesh(points, {facet::surfaceBreaking, facet::front});
}

/// From the last point of a line.
double atEnd(const CrackMesh<2>& mesh, double radius, double slack)
{
  return Returns<2>(mesh).find({static_cast<int>(mesh.simplices.size()) - 1}, {mesh.vertices.back()}, radius,
                               slack);
}

/// A strip that goes along x, up by a height and back, as triangles.
CrackMesh<3> foldedStrip(int length, double height)
{
  CrackMesh<3> mesh;
  std::vector<Vector<2>> path;
  for (int k = 0; k <= length; ++k)
    path.push_back({double(k), 0.0});
  for (int k = length; k >= 0; --k)
    path.push_back({double(k), height});
  for (const Vector<2>& x : path)
    for (const double z : {0.0, 1.0})
      mesh.vertices.push_back({x[0], x[1], z});
  const int last = static_cast<int>(path.size()) - 2;
  for (int k = 0; k <= last; ++k)
  {
    const int t = 2 * k;
    mesh.simplices.push_back({2 * k, 2 * k + 2, 2 * k + 1});
    mesh.simplices.push_back({2 * k + 2, 2 * k + 3, 2 * k + 1});
    // Facet i is opposite to corner i.
    mesh.beyond.push_back({t + 1, k == 0 ? facet::surfaceBreaking : t - 1, facet::surfaceBreaking});
    mesh.beyond.push_back({facet::surfaceBreaking, t, k == last ? facet::front : t + 2});
  }
  return mesh;
}

} // namespace

/// Lines that turn by up to a right angle go away from their end all along.
TEST(Returns, LinesThatBendDoNot)
{
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> turn(-1.5, 1.5), length(0.3, 3.0);
  for (int trial = 0; trial < 50; ++trial)
  {
    const double kink = turn(engine), first = length(engine);
    const CrackMesh<2> mesh =
        lineOf({{0.0, 0.0}, {first, 0.0}, {first + 2.0 * std::cos(kink), 2.0 * std::sin(kink)}});
    EXPECT_EQ(atEnd(mesh, 10.0, 1e-9), 10.0) << kink;
  }
}

/// A hairpin comes back to the distance of its legs, where that is less than what is of interest.
TEST(Returns, HairpinsDoToTheDistanceOfTheirLegs)
{
  for (const double gap : {0.1, 0.5, 1.0})
  {
    const CrackMesh<2> mesh = lineOf({{0.0, 0.0}, {5.0, 0.0}, {5.0, gap}, {2.0, gap}});
    EXPECT_NEAR(atEnd(mesh, 2.0, 0.5), gap, 1e-12);
    EXPECT_EQ(atEnd(mesh, 0.5 * gap, 0.5), 0.5 * gap);
    EXPECT_EQ(atEnd(mesh, 2.0, 4.0), 2.0); // the slack is more than the way round the bend
  }
}

/// A circle that does not close: the distance of its ends.
TEST(Returns, OpenRingsDoToTheirOtherEnd)
{
  std::vector<Vector<2>> points;
  for (int k = 0; k <= 100; ++k)
    points.push_back({std::cos(0.06 * k), std::sin(0.06 * k)});
  const double open = norm(points.back() - points.front());
  EXPECT_NEAR(atEnd(lineOf(points), 1.5, 0.1), open, 1e-12);
}

/// All of another crack is apart.
TEST(Returns, WithoutAStartAllCounts)
{
  const CrackMesh<2> mesh = lineOf({{0.0, 0.0}, {5.0, 0.0}});
  EXPECT_NEAR(Returns<2>(mesh).find({}, {{1.0, 0.7}}, 2.0, 0.5), 0.7, 1e-12);
}

TEST(Returns, FoldedSurfacesDo)
{
  for (const double height : {0.3, 1.0, 2.0})
  {
    const CrackMesh<3> mesh = foldedStrip(8, height);
    const Vector<3> at{0.0, height, 0.5}; // the middle of the last edge
    EXPECT_NEAR(Returns<3>(mesh).find({static_cast<int>(mesh.simplices.size()) - 1}, {at}, 3.0, 1.5), height,
                1e-12);
  }
  EXPECT_EQ(Returns<3>(foldedStrip(8, 5.0)).find({0}, {{0.0, 0.0, 0.5}}, 3.0, 1.5), 3.0);
}
