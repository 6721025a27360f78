#include "surface/Triangulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace Rhegma;
using namespace Rhegma::surface;

namespace
{

using Points = std::vector<Vector<2>>;

double area(const Triangulation& mesh)
{
  double sum = 0.0;
  for (const auto& t : mesh.triangles)
  {
    const double twice = doubleArea(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
    EXPECT_GT(twice, 0.0);
    sum += 0.5 * twice;
  }
  return sum;
}

double longestEdge(const Triangulation& mesh)
{
  double longest = 0.0;
  for (const auto& t : mesh.triangles)
    for (int i = 0; i < 3; ++i)
      longest = std::max(longest, norm(mesh.points[t[(i + 1) % 3]] - mesh.points[t[i]]));
  return longest;
}

/// Euler: a disk has points - edges + triangles = 1.
int eulerNumber(const Triangulation& mesh)
{
  int border = 0;
  for (const auto& beyond : findNeighbours(mesh.triangles))
    border += static_cast<int>(std::count(beyond.begin(), beyond.end(), -1));
  const int triangles = static_cast<int>(mesh.triangles.size());
  return static_cast<int>(mesh.points.size()) - (3 * triangles + border) / 2 + triangles;
}

const Points square{{0.0, 0.0}, {4.0, 0.0}, {4.0, 4.0}, {0.0, 4.0}};
const Points hook{{0.0, 0.0}, {5.0, 0.0}, {5.0, 5.0}, {3.0, 5.0}, {3.0, 2.0}, {0.0, 2.0}};

Points star(int tips)
{
  Points points;
  for (int k = 0; k < 2 * tips; ++k)
  {
    const double angle = std::acos(-1.0) * k / tips, radius = k % 2 == 0 ? 6.0 : 2.5;
    points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return points;
}

double polygonArea(const Points& points)
{
  double sum = 0.0;
  for (std::size_t k = 0; k < points.size(); ++k)
    sum += 0.5 * doubleArea({0.0, 0.0}, points[k], points[(k + 1) % points.size()]);
  return sum;
}

} // namespace

/// The triangles tile the polygon: areas to round-off, one border, no hole.
TEST(Triangulation, TilesPolygons)
{
  for (const Points& outline : {square, hook, star(5), star(12)})
    for (const double spacing : {10.0, 1.0, 0.37})
    {
      const Triangulation mesh = triangulate(outline, spacing);
      EXPECT_NEAR(area(mesh), polygonArea(outline), 1e-12 * polygonArea(outline)) << "at spacing " << spacing;
      EXPECT_EQ(eulerNumber(mesh), 1) << "at spacing " << spacing;
    }
}

/// Triangles of a Delaunay triangulation of points this dense have circles that contain none, of a radius of
/// at most 1.2 spacings (0.6 to the border and 0.6 on), so no edge is longer than twice that; a fan would
/// have edges of 4.
TEST(Triangulation, HasTrianglesAsSmallAsAskedFor)
{
  for (const Points& outline : {square, hook})
    EXPECT_LE(longestEdge(triangulate(outline, 0.5)), 2.4 * 0.5);
}

/// No circle around a triangle contains the point beyond one of its edges, except for the 1e-9 of a spacing's
/// fourth power that is taken for round-off: Delaunay's condition edge by edge.
TEST(Triangulation, IsDelaunays)
{
  for (const Points& outline : {square, hook, star(5)})
    for (const double spacing : {1.0, 0.1})
    {
      const Triangulation mesh = triangulate(outline, spacing);
      const auto beyond = findNeighbours(mesh.triangles);
      int inner = 0, wrong = 0;
      for (std::size_t t = 0; t < beyond.size(); ++t)
        for (int i = 0; i < 3; ++i)
        {
          if (beyond[t][i] < 0)
            continue;
          ++inner;
          const auto& corners = mesh.triangles[t];
          const Vector<2>&a = mesh.points[corners[0]], &b = mesh.points[corners[1]],
                &c = mesh.points[corners[2]];
          // The middle of the circle, from c.
          const Vector<2> p = a - c, q = b - c;
          const double twice = 2.0 * doubleArea(a, b, c);
          const Vector<2> middle{(q[1] * dot(p, p) - p[1] * dot(q, q)) / twice,
                                 (p[0] * dot(q, q) - q[0] * dot(p, p)) / twice};
          for (const int v : mesh.triangles[beyond[t][i]])
            if (std::count(corners.begin(), corners.end(), v) == 0)
              wrong += norm(mesh.points[v] - c - middle) < norm(middle) * (1.0 - 1e-6) ? 1 : 0;
        }
      EXPECT_GT(inner, static_cast<int>(beyond.size()));
      EXPECT_EQ(wrong, 0) << "at spacing " << spacing;
    }
}

/// A straight cut is exact to the tolerance of its halvings, 1e-3 of an edge.
TEST(Triangulation, IsCutOffOutside)
{
  const Triangulation whole = triangulate(square, 0.5);
  const Triangulation cut = cutToRegion(whole, [](const Vector<2>& x) { return x[0] < 1.234 + 0.1 * x[1]; });
  EXPECT_NEAR(area(cut), 4.0 * 1.234 + 0.1 * 8.0, 4.0 * 2e-3 * longestEdge(whole));
  EXPECT_EQ(eulerNumber(cut), 1);
  for (const Vector<2>& x : cut.points)
    EXPECT_LE(x[0], 1.234 + 0.1 * x[1]);
  EXPECT_TRUE(cutToRegion(whole, [](const Vector<2>&) { return false; }).triangles.empty());
  EXPECT_EQ(cutToRegion(whole, [](const Vector<2>&) { return true; }).triangles.size(),
            whole.triangles.size());
  // A corner of the region that lies inside of triangles: the cut that runs past it is filled.
  const Triangulation corner =
      cutToRegion(whole, [](const Vector<2>& x) { return x[0] < 2.13 && x[1] < 1.71; });
  EXPECT_NEAR(area(corner), 2.13 * 1.71, 4e-3 * 2.13 * 1.71);
}

/// What is left of a border ends where the region does: its corners next to the cut move along it, by no more
/// than the tolerance of the cut, 1e-3 of an edge at each of two ends.
TEST(Triangulation, KeepsItsBorderWhereItIsCut)
{
  constexpr int corners = 33; // the region's border meets edges, not corners
  constexpr double radius = 5.0, step = 2.0 * 3.14159265358979 / corners;
  Points outline;
  outline.reserve(corners);
  for (int k = 0; k < corners; ++k)
    outline.push_back({radius * std::cos(k * step), radius * std::sin(k * step)});
  const double from = 0.31;
  double left = 0.0; // length of the outline in the region
  for (int k = 0; k < corners; ++k)
  {
    const Vector<2>&a = outline[k], &b = outline[(k + 1) % corners];
    const double low = std::min(a[0], b[0]), high = std::max(a[0], b[0]);
    left += std::clamp((high - from) / (high - low), 0.0, 1.0) * norm(b - a);
  }
  const Triangulation cut =
      cutToRegion(triangulate(outline, 1.0), [&](const Vector<2>& x) { return x[0] > from; });
  const auto neighbours = findNeighbours(cut.triangles);
  double kept = 0.0;
  for (std::size_t t = 0; t < cut.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i)
    {
      const Vector<2>&a = cut.points[cut.triangles[t][(i + 1) % 3]],
            &b = cut.points[cut.triangles[t][(i + 2) % 3]];
      const Vector<2> middle = 0.5 * (a + b);
      double nearest = radius;
      for (int k = 0; k < corners; ++k)
      {
        const Vector<2> along = outline[(k + 1) % corners] - outline[k], off = middle - outline[k];
        nearest = std::min(nearest, std::fabs(along[0] * off[1] - along[1] * off[0]) / norm(along));
      }
      if (neighbours[t][i] < 0 && nearest < 1e-9)
        kept += norm(b - a);
    }
  EXPECT_NEAR(kept, left, 2e-3);
}
