#include "Surfaces.hpp"

#include "geometry/MendSurface.hpp"
#include "geometry/OutlineFile.hpp"
#include "geometry/Solid.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <limits>
#include <set>
#include <stdexcept>

using namespace Rhegma;
using namespace Rhegma::Geometry;
using namespace Surfaces;

namespace
{

std::string refusalOf(const SurfaceMesh& mesh)
{
  try
  {
    mendSurface(mesh);
  }
  catch (const std::invalid_argument& wrong)
  {
    return wrong.what();
  }
  return "";
}

std::string outlineRefusal(const std::string& text)
{
  try
  {
    mendOutlines(parseOutlines(text));
  }
  catch (const std::invalid_argument& wrong)
  {
    return wrong.what();
  }
  return "";
}

/// The volume after mending, and the notes as one text.
std::pair<double, std::string> mended(const SurfaceMesh& mesh)
{
  MendedSurface<3> found = mendSurface(mesh);
  std::string notes;
  for (const std::string& note : found.notes)
    notes += note + "; ";
  return {Solid<3>(std::move(found.surface), found.resolution).volume(), notes};
}

/// The angle that a triangle covers as seen from x, over 4 pi (A. van Oosterom, J. Strackee: IEEE Trans.
/// Biomed. Eng. 30 (1983) 125-126): all together 1 inside and 0 outside.
double windingOf(const SurfaceMesh& mesh, const Vector<3>& x)
{
  double sum = 0.0;
  for (const auto& t : mesh.triangles)
  {
    const Vector<3> a = mesh.points[t[0]] - x, b = mesh.points[t[1]] - x, c = mesh.points[t[2]] - x;
    const double la = norm(a), lb = norm(b), lc = norm(c);
    sum += std::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
  }
  return sum / (2.0 * pi);
}

double distanceTo(const SurfaceMesh& mesh, const Vector<3>& x)
{
  double least = std::numeric_limits<double>::infinity();
  for (const auto& t : mesh.triangles)
  {
    const Vector<3> corner[3] = {mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]};
    least = std::min(least, distanceToSimplex(corner, x));
  }
  return least;
}

} // namespace

/// The distance agrees with that to each triangle, the side with the solid angle of all, near the surface and
/// far from it, of parts with cavities, holes and edges, in any position.
TEST(Solids, KnowTheirDepthAtRandomPoints)
{
  std::mt19937 random(seedOf("Solids.KnowTheirDepthAtRandomPoints"));
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (const SurfaceMesh& part :
       {both(sphere(9, 1.0), insideOut(sphere(7, 0.6, {0.1, 0.0, 0.2}))), torus(17, 9, 1.0, 0.4),
        bracket(3, 0.35, 0.3),
        both(brick({0.0, 0.0, 0.0}, {1.0, 2.0, 0.1}), sphere(6, 0.4, {0.5, 1.0, 0.8}))})
  {
    const SurfaceMesh mesh = anywhere(part, random);
    MendedSurface<3> found = mendSurface(mesh);
    EXPECT_TRUE(found.notes.empty()) << found.notes.front();
    const Solid<3> solid(std::move(found.surface), found.resolution);
    EXPECT_NEAR(solid.volume(), volumeOf(mesh), 1e-12);
    for (int k = 0; k < 1500; ++k)
    {
      Vector<3> x{2.5 * unit(random), 2.5 * unit(random), 2.5 * unit(random)};
      if (k % 3 > 0) // near an edge or a corner
        x = mesh.points[random() % mesh.points.size()] + (k % 3 == 1 ? 0.1 : 1e-6) * x;
      const double distance = distanceTo(mesh, x);
      const double right = windingOf(mesh, x) > 0.5 ? distance : -distance;
      EXPECT_NEAR(solid.depth(x, 100.0), right, 1e-12) << x[0] << ' ' << x[1] << ' ' << x[2];
      EXPECT_NEAR(solid.depth(x, 0.05), std::clamp(right, -0.05, 0.05), 1e-12);
    }
  }
}

/// Mistakes with one possible correction are mended, with a message that says what, how often and where.
TEST(Surfaces, AreMendedWithANote)
{
  const SurfaceMesh cube = brick({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}), ball = sphere(8, 1.0);
  const auto expect = [](const SurfaceMesh& mesh, double volume, const std::vector<std::string>& words)
  {
    const auto [found, notes] = mended(mesh);
    EXPECT_NEAR(found, volume, 1e-5 * volume);
    expectWords(notes, words);
    EXPECT_EQ(notes.empty(), words.empty()) << notes;
  };
  expect(cube, 1.0, {});
  expect(insideOut(cube), 1.0, {"inside out (1 shell)", "turned"});
  SurfaceMesh one = ball;
  std::swap(one.triangles[20][0], one.triangles[20][1]);
  expect(one, volumeOf(ball), {"1 triangle", "was oriented against", "and turned"});
  SurfaceMesh apart =
      cube; // each triangle with points of its own, which differ by the rounding of six digits
  for (std::size_t p = 0; p < apart.points.size(); ++p)
    apart.points[p][p % 3] += 3e-6 * static_cast<double>(p % 2);
  expect(apart, 1.0, {"pairs of points", "merged"});
  SurfaceMesh flat = cube;
  flat.triangles.push_back({0, 0, 1});
  expect(flat, 1.0, {"1 triangle without area was left out"});
  SurfaceMesh twice = cube;
  twice.triangles.push_back(cube.triangles[3]);
  expect(twice, 1.0, {"1 triangle with the same points as another", "was left out"});
  twice.triangles.push_back(cube.triangles[2]); // its neighbour
  twice.triangles.push_back(cube.triangles[2]);
  expect(twice, 1.0, {"3 triangles with the same points as others", "were left out"});
  SurfaceMesh leaf = cube; // a triangle and its back side, which hang on an edge
  addTriangle(leaf, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.5, -1.0, -1.0});
  addTriangle(leaf, {0.0, 0.0, 0.0}, {0.5, -1.0, -1.0}, {1.0, 0.0, 0.0});
  expect(leaf, 1.0, {"2 triangles with the same points", "were left out"});
  expect(insideOut(both(brick({0.0, 0.0, 0.0}, {3.0, 3.0, 3.0}),
                        insideOut(moved(cube,
                                        [](const Vector<3>& x) {
                                          return x + Vector<3>{1.0, 1.0, 1.0};
                                        })))),
         26.0, {"inside out (2 shells)"});
}

/// A needle whose tip lies on the edge of its neighbour, or over it by rounding, does not change the side of
/// points.
TEST(Surfaces, MayHaveTrianglesWithoutHeight)
{
  for (const double over : {-1e-8, 0.0, 1e-8})
  {
    const Vector<3> a{0.0, 0.0, 1.0}, b{1.0, 0.0, 1.0}, c{1.0, 1.0, 1.0}, d{0.0, 1.0, 1.0},
        m{0.5 + over, 0.5, 1.0};
    SurfaceMesh mesh;
    for (const auto& t : brick({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}).triangles)
    {
      const SurfaceMesh cube = brick({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0});
      if (cube.points[t[0]][2] + cube.points[t[1]][2] + cube.points[t[2]][2] < 3.0)
        addTriangle(mesh, cube.points[t[0]], cube.points[t[1]], cube.points[t[2]]);
    }
    addTriangle(mesh, a, b, c);
    addTriangle(mesh, a, c, m);
    addTriangle(mesh, a, m, d);
    addTriangle(mesh, m, c, d);
    MendedSurface<3> found = mendSurface(mesh);
    const Solid<3> solid(std::move(found.surface), found.resolution);
    for (int k = 0; k <= 50; ++k)
      for (const double height : {-0.3, -1e-3, 1e-3, 0.3})
        EXPECT_NEAR(
            solid.depth({0.02 * k, 0.02 * k, 1.0 + height}, 0.2),
            height > 0.0 ? -std::min(height, 0.2) : std::min({-height, 0.2, 0.02 * k, 1.0 - 0.02 * k}), 1e-7);
  }
}

TEST(Surfaces, ThatBoundNoSolidAreRefused)
{
  const SurfaceMesh cube = brick({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0});
  const auto shifted = [&](double x, double y, double z) {
    return moved(cube, [=](const Vector<3>& p) { return p + Vector<3>{x, y, z}; });
  };
  SurfaceMesh open = cube;
  open.triangles.pop_back();
  expectWords(refusalOf(open), {"not closed", "3 edges belong to one triangle only", "1 gap at", "across"});
  SurfaceMesh apart = cube;
  for (int i = 0; i < 3; ++i)
    apart.points[apart.triangles[0][i]][0] += 1e-3; // more than rounding
  expectWords(refusalOf(apart), {"not closed"});
  expectWords(refusalOf(both(cube, shifted(0.5, 0.4, 0.3))),
              {"shells touch or overlap", "triangles meet, such as near"});
  expectWords(refusalOf(both(cube, moved(cube,
                                         [](const Vector<3>& p) {
                                           return Vector<3>{1.0 + p[0], 0.2 + 0.5 * p[1], 0.3 + 0.5 * p[2]};
                                         }))),
              {"shells touch or overlap"});
  expectWords(refusalOf(both(cube, shifted(1.0, 1.0, 0.0))),
              {"1 edge belongs to more than two triangles", "from (1, 1"});
  expectWords(refusalOf(both(brick({-1.0, -1.0, -1.0}, {2.0, 2.0, 2.0}), cube)),
              {"inside another shell", "cavity"});
  SurfaceMesh crossed = sphere(8, 1.0);
  for (Vector<3>& x : crossed.points)
    if (x[2] == 1.0)
      x[2] = -1.5; // its pole is pulled through the other side
  expectWords(refusalOf(crossed), {"intersects itself"});
  SurfaceMesh nothing;
  addTriangle(nothing, {1.0, 1.0, 1.0}, {1.0, 1.0, 1.0}, {1.0, 1.0, 1.0});
  expectWords(refusalOf(nothing), {"area"});
}

/// Polygons inside others are holes, and those in holes material; their sense of rotation does not matter.
TEST(Outlines, HaveHoles)
{
  const std::string text =
      "# a ring with an island\n0 0\n4, 0\n4 4\n0 4\n\n1 1\n1 3\n3 3\n3 1\n1 1\n\n\n1.5 1.5\n"
      "2.5 1.5 # a comment\n# another\n2.5 2.5\n1.5 2.5\n1.5 2.5\n";
  MendedSurface<2> found = mendOutlines(parseOutlines(text));
  ASSERT_EQ(found.notes.size(), 1u);
  expectWords(found.notes[0], {"1 point that repeats"});
  const Solid<2> solid(std::move(found.surface), 0.0);
  EXPECT_NEAR(solid.volume(), 16.0 - 4.0 + 1.0, 1e-14);
  EXPECT_NEAR(solid.depth({0.5, 2.0}, 10.0), 0.5, 1e-15);
  EXPECT_NEAR(solid.depth({1.2, 2.0}, 10.0), -0.2, 1e-15);
  EXPECT_NEAR(solid.depth({2.0, 2.1}, 10.0), 0.4, 1e-15);
  EXPECT_NEAR(solid.depth({5.0, 5.0}, 10.0), -std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(solid.depth({2.0, 2.1}, 0.1), 0.1, 1e-15);
}

TEST(Outlines, ThatAreWrongAreRefused)
{
  expectWords(outlineRefusal("0 0\n1 0\n1 x\n"), {"line 3 holds no point"});
  expectWords(outlineRefusal("<?xml version=\"1.0\"?>\n<svg/>\n"), {"SVG", "tools/rhegma-mesh"});
  expectWords(outlineRefusal("0 0\n1 0 2\n"), {"line 2"});
  expectWords(outlineRefusal("0 0\n1 0\n1 nan\n"), {"line 3"});
  expectWords(outlineRefusal("# nothing\n\n"), {"no point"});
  expectWords(outlineRefusal("0 0\n1 0\n"), {"begins at line 1 has no area"});
  expectWords(outlineRefusal("0 0\n1 1\n1 0\n0 2\n"), {"begins at line 1 meets itself"});
  expectWords(outlineRefusal("0 0\n2 0\n2 2\n0 2\n\n1 1\n3 1\n3 3\n"),
              {"begins at line 1 meets the polygon that begins at line 6"});
  expectWords(outlineRefusal("0 0\n2 0\n1 0\n1 1\n"), {"meets itself"}); // it turns back
}
