#include "geometry/SurfacePieces.hpp"

#include "Surfaces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <vector>

using namespace Rhegma;
using namespace Rhegma::Geometry;
using Surfaces::seedOf;

namespace
{

constexpr double cube = 0.25;

/// Area of the points that look along each side of each axis.
std::map<int, double> areas(const std::vector<SurfacePoint<3>>& points)
{
  std::map<int, double> sum;
  for (const SurfacePoint<3>& point : points)
    for (int d = 0; d < 3; ++d)
      if (std::abs(point.normal[d]) > 0.9)
        sum[point.normal[d] > 0.0 ? d : -d - 1] += point.size;
  return sum;
}

} // namespace

/// Triangles of any size, of the top and the bottom of a plate in any order: both sides keep their areas and
/// first moments, and points lie on the plate.
TEST(SurfacePieces, DoNotDependOnOrderAndSize)
{
  std::mt19937 random(seedOf("SurfacePieces"));
  for (const double leg : {cube / 4.0, cube / 3.0, 0.2, 1.0, 3.0})
    for (const bool shuffled : {false, true})
    {
      const int across = std::max(1, static_cast<int>(std::lround(3.0 / leg)));
      const double step = 3.0 / across;
      struct Triangle
      {
        Vector<3> corner[3];
        double side;
      };
      std::vector<Triangle> triangles;
      for (int i = 0; i < across; ++i)
        for (int j = 0; j < across; ++j)
          for (int half = 0; half < 2; ++half)
            for (const double side : {-1.0, 1.0}) // one of each in turn, as some programs write them
            {
              const double x = i * step, y = j * step, z = 0.5 * side, to = step;
              triangles.push_back(
                  half == 0 ? Triangle{{{{x, y, z}}, {{x + to, y, z}}, {{x, y + to, z}}}, side}
                            : Triangle{{{{x + to, y + to, z}}, {{x, y + to, z}}, {{x + to, y, z}}}, side});
            }
      if (shuffled)
        std::shuffle(triangles.begin(), triangles.end(), random);
      Pieces<3> pieces(cube);
      for (const Triangle& triangle : triangles)
        pieces.addDivided(triangle.corner, {{0.0, 0.0, triangle.side}}, 0.5 * step * step);
      std::vector<SurfacePoint<3>> points;
      pieces.gather(points);
      const auto found = areas(points);
      EXPECT_NEAR(found.at(2), 9.0, 1e-12) << leg;
      EXPECT_NEAR(found.at(-3), 9.0, 1e-12) << leg;
      double moment = 0.0;
      for (const SurfacePoint<3>& point : points)
      {
        EXPECT_EQ(std::abs(point.x[2]), 0.5);
        moment += point.size * point.normal[2] * point.x[0];
      }
      EXPECT_NEAR(moment, 0.0, 18.0 * cube); // half a cube a point at most
      EXPECT_LE(points.size(), 2 * 13 * 13u);
    }
}

/// The resultant of a closed surface is zero, of a ball of triangles of any orientation, and its area is that
/// of the triangles.
TEST(SurfacePieces, OfAClosedSurfaceHaveNoResultant)
{
  std::mt19937 random(seedOf("SurfacePieces"));
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  for (int trial = 0; trial < 5; ++trial)
  {
    const double radius = 1.5 + 0.5 * part(random);
    const int rows = 5 + 8 * trial;
    const auto at = [&](int i, int j)
    {
      const double polar = Surfaces::pi * i / rows, around = Surfaces::pi * j / rows;
      return radius * Vector<3>{{std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around),
                                 std::cos(polar)}};
    };
    Pieces<3> pieces(cube);
    double area = 0.0;
    const auto add = [&](const Vector<3>& a, const Vector<3>& b, const Vector<3>& c)
    {
      const Vector<3> normal = cross(b - a, c - a);
      const Vector<3> corner[3] = {a, b, c};
      if (!(norm(normal) > 1e-12))
        return;
      area += 0.5 * norm(normal);
      pieces.addDivided(corner, (1.0 / norm(normal)) * normal, 0.5 * norm(normal));
    };
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j < 2 * rows; ++j)
      {
        add(at(i, j), at(i + 1, j), at(i + 1, j + 1));
        add(at(i, j), at(i + 1, j + 1), at(i, j + 1));
      }
    std::vector<SurfacePoint<3>> points;
    pieces.gather(points);
    double sum = 0.0;
    Vector<3> resultant{};
    for (const SurfacePoint<3>& point : points)
    {
      sum += point.size;
      resultant = resultant + point.size * point.normal;
    }
    EXPECT_NEAR(sum, area, 1e-11 * area);
    // Normals in a cube differ by a quarter at most: their mean is shorter by the square of half of it over
    // two.
    EXPECT_LT(norm(resultant), 0.01 * area);
  }
}
