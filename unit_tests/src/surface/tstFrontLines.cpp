#include "surface/GrowingSurface.hpp"

#include <gtest/gtest.h>

using namespace Rhegma;
using namespace Rhegma::surface;

namespace
{

/// Points 0, 1, ... of a line, closed or open.
FrontLines<3> line(int count, bool closed)
{
  FrontLines<3> lines(count);
  for (int k = 0; k < count; ++k)
  {
    lines[k].vertex = lines[k].name = lines[k].origin = k;
    lines[k].joined = closed || k + 1 < count;
    lines[k].direction = {1.0, 0.0, 0.0};
    lines[k].normal = {0.0, 0.0, 1.0};
  }
  return lines;
}

/// A strip of two triangles for each piece of a front of 5 points along y, one unit wide.
GrowingSurface strip()
{
  GrowingSurface sheet;
  for (int k = 0; k < 5; ++k)
    sheet.vertices.push_back({1.0, double(k), 0.0});
  for (int k = 0; k < 5; ++k)
    sheet.vertices.push_back({0.0, double(k), 0.0});
  for (int k = 0; k < 4; ++k)
  {
    sheet.triangles.push_back({k, k + 1, k + 5});
    sheet.triangles.push_back({k + 5, k + 1, k + 6});
  }
  for (const Vector<3>& x : sheet.vertices)
    sheet.faces.push_back({x, x});
  sheet.prepare();
  return sheet;
}

double areaOf(const GrowingSurface& sheet)
{
  double area = 0.0;
  for (const auto& t : sheet.triangles)
    if (t[0] >= 0)
    {
      const Vector<3> a = sheet.vertices[t[1]] - sheet.vertices[t[0]],
                      b = sheet.vertices[t[2]] - sheet.vertices[t[0]];
      area += 0.5 * std::fabs(a[0] * b[1] - a[1] * b[0]);
    }
  return area;
}

} // namespace

TEST(FrontLines, KnowTheirNeighbours)
{
  const FrontLines<3> open = line(3, false), closed = line(3, true);
  EXPECT_EQ(previousPoint(open, 0), -1);
  EXPECT_EQ(previousPoint(closed, 0), 2);
  EXPECT_EQ(previousPoint(open, 2), 1);
  EXPECT_EQ(nextPoint(open, 2), 0u);
}

/// Two landed neighbours of a closed line of six: the piece between them is removed, and the line begins
/// behind it. Two more at its end: the last piece is removed, with the then isolated point.
TEST(FrontLines, AreCutBetweenLandedPoints)
{
  FrontLines<3> lines = line(6, true);
  lines[2].landed = lines[3].landed = true;
  cutLanded(lines);
  ASSERT_EQ(lines.size(), 6u);
  EXPECT_EQ(lines.front().name, 3);
  EXPECT_EQ(lines.back().name, 2);
  EXPECT_FALSE(lines.back().joined);
  lines[4].landed = true;
  cutLanded(lines);
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_EQ(lines.back().name, 1);
}

/// A front in 2D is empty once its only point has landed.
TEST(FrontLines, OfOnePointEndWithIt)
{
  FrontLines<2> tip(1);
  cutLanded(tip);
  EXPECT_EQ(tip.size(), 1u);
  tip[0].landed = true;
  cutLanded(tip);
  EXPECT_TRUE(tip.empty());
}

TEST(FrontLines, TakeTheToughnessOfThoseThatHaveGrown)
{
  FrontPoint<3> a, b;
  a.toughness = 10.0;
  EXPECT_EQ(meanToughness(a, b), 10.0);
  b.toughness = 20.0;
  EXPECT_EQ(meanToughness(a, b), 15.0);
}

/// A point that goes 0.2 on stretches its triangles: half of 0.2 for each of its two pieces. Beyond the
/// height of a row it puts a new point there instead. What is returned is the area that is gained.
TEST(GrowingSurface, StretchesThenBeginsARow)
{
  GrowingSurface sheet = strip();
  FrontLines<3> lines = line(5, false);
  EXPECT_NEAR(sheet.advance(lines, 2, {1.2, 2.0, 0.0}, 2.0), 0.2, 1e-14);
  EXPECT_EQ(sheet.triangles.size(), 8u);
  EXPECT_EQ(lines[2].vertex, 2);
  const double before = areaOf(sheet), more = sheet.advance(lines, 2, {3.2, 2.0, 0.0}, 2.0);
  EXPECT_NEAR(areaOf(sheet), before + more, 1e-14);
  EXPECT_EQ(sheet.triangles.size(), 10u);
  EXPECT_EQ(lines[2].vertex, 10);
  // A turn of more than ten degrees begins a row too.
  sheet.advance(lines, 1, {1.1, 1.1, 0.0}, 2.0);
  EXPECT_EQ(sheet.triangles.size(), 12u);
}

/// Splitting a piece and merging its ends again change no area of a straight front.
TEST(GrowingSurface, SplitsAndMergesPieces)
{
  GrowingSurface sheet = strip();
  FrontLines<3> lines = line(5, false);
  sheet.split(lines, 1, 7);
  ASSERT_EQ(lines.size(), 6u);
  EXPECT_EQ(lines[2].name, 7);
  EXPECT_EQ(lines[2].from, 1);
  EXPECT_NEAR(areaOf(sheet), 4.0, 1e-14);
  double added = 1.0;
  ASSERT_TRUE(sheet.collapse(lines, 2, added));
  EXPECT_EQ(lines.size(), 5u);
  EXPECT_NEAR(added, 0.0, 1e-14);
  EXPECT_NEAR(areaOf(sheet), 4.0, 1e-14);
  sheet.tidy({&lines});
  EXPECT_EQ(sheet.triangles.size(), 8u);
  const CrackMesh<3> mesh = sheet.mesh({&lines});
  int fronts = 0, breaking = 0;
  for (const auto& beyond : mesh.beyond)
    for (const int b : beyond)
    {
      fronts += b == facet::front ? 1 : 0;
      breaking += b == facet::surfaceBreaking ? 1 : 0;
    }
  EXPECT_EQ(fronts, 4);
  EXPECT_EQ(breaking, 6);
}
