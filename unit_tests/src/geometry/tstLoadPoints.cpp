#include "geometry/LoadPoints.hpp"

#include "geometry/NearestPoint.hpp"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>
#include <string>

using namespace Rhegma;

namespace
{

/// nx * ny (* nz) unit particles, the first with its lower corner at the origin.
Seeds<2> sheet(int nx, int ny)
{
  Seeds<2> seeds{};
  seeds.edge = {{1.0, 1.0}};
  seeds.axes = Geometry::spaceAxes<2>();
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i)
      seeds.position.push_back({{i + 0.5, j + 0.5}});
  return seeds;
}

Seeds<3> block(int nx, int ny, int nz)
{
  Seeds<3> seeds{};
  seeds.edge = {{1.0, 1.0, 1.0}};
  seeds.axes = Geometry::spaceAxes<3>();
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i)
        seeds.position.push_back({{i + 0.5, j + 0.5, k + 0.5}});
  return seeds;
}

template <int D>
double sumOfFractions(const std::vector<LoadPoint<D>>& points)
{
  double sum = 0.0;
  for (const auto& p : points)
    sum += p.fraction;
  return sum;
}

/// Moment of the fractions about the origin: where the resultant acts.
template <int D>
Vector<D> resultant(const Seeds<D>& body, const std::vector<LoadPoint<D>>& points)
{
  Vector<D> middle{};
  for (const auto& p : points)
    middle = middle + p.fraction * (body.position[p.particle] + p.offset);
  return middle;
}

template <class Call>
std::string errorOf(const Call& call)
{
  try
  {
    call();
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "";
}

} // namespace

/// The corner (4, 2) is nearest to the last of 4 x 2 particles, whose centre is (3.5, 1.5).
TEST(LoadPoints, PointMovesWithTheNearestParticle)
{
  const auto points = pointLoad<2>(sheet(4, 2), {{4.0, 2.0}}, "Load");
  ASSERT_EQ(points.size(), 1u);
  EXPECT_EQ(points[0].particle, 7);
  EXPECT_DOUBLE_EQ(points[0].offset[0], 0.5);
  EXPECT_DOUBLE_EQ(points[0].offset[1], 0.5);
  EXPECT_DOUBLE_EQ(points[0].fraction, 1.0);
}

/// Of two equally near particles the first gets the point, whatever the rounding.
TEST(LoadPoints, EquallyNearGoesToTheFirstParticle)
{
  EXPECT_EQ(pointLoad<2>(sheet(4, 2), {{2.0, 2.0}}, "Load")[0].particle, 5);
  EXPECT_EQ(pointLoad<3>(block(4, 2, 1), {{2.0, 1.0, 1.0}}, "Load")[0].particle, 1);
}

/// A diagonal is 1.414 m long: 1.4 m above the top centre is caught, 1.5 m is not.
TEST(LoadPoints, PointFarFromTheBodyIsAnError)
{
  EXPECT_EQ(pointLoad<2>(sheet(4, 2), {{0.5, 2.9}}, "Load")[0].particle, 4);
  const auto message = errorOf([] { pointLoad<2>(sheet(4, 2), {{0.5, 3.0}}, "Boundaries > Tip"); });
  EXPECT_EQ(message.find("Boundaries > Tip: the load misses the body: the point (0.5, 3) m"), 0u) << message;
}

/// 4 m in pieces of half an edge: 8 points of 1/8, two on every particle of the right column.
TEST(LoadPoints, UniformLine)
{
  const auto body = sheet(3, 4);
  const auto points = lineLoad<2>(body, {{3.0, 0.0}}, {{3.0, 4.0}}, Profile::Uniform, "Load");
  ASSERT_EQ(points.size(), 8u);
  for (int i = 0; i < 8; ++i)
  {
    EXPECT_DOUBLE_EQ(points[i].fraction, 0.125);
    EXPECT_EQ(points[i].particle, 2 + 3 * (i / 2));
    EXPECT_DOUBLE_EQ(points[i].offset[0], 0.5);
    EXPECT_DOUBLE_EQ(points[i].offset[1], i % 2 == 0 ? -0.25 : 0.25);
  }
}

/// Midpoint weights s (1 - s) of 4 points are 7, 15, 15, 7 (over 64), so the fractions are 7/44 and 15/44.
TEST(LoadPoints, ParabolicLineIsRenormalised)
{
  const auto body = sheet(3, 2);
  const auto points = lineLoad<2>(body, {{3.0, 0.0}}, {{3.0, 2.0}}, Profile::Parabolic, "Load");
  ASSERT_EQ(points.size(), 4u);
  EXPECT_DOUBLE_EQ(points[0].fraction, 7.0 / 44.0);
  EXPECT_DOUBLE_EQ(points[1].fraction, 15.0 / 44.0);
  EXPECT_NEAR(points[3].fraction, 7.0 / 44.0, 2.0e-16);
}

/// Fractions add up to 1 to the last bit for any number of points.
TEST(LoadPoints, FractionsAddUpToOneExactly)
{
  for (int n = 1; n <= 60; ++n)
  {
    const auto body = sheet(1, n);
    for (const auto profile : {Profile::Uniform, Profile::Parabolic})
    {
      const auto points = lineLoad<2>(body, {{1.0, 0.0}}, {{1.0, 1.0 * n}}, profile, "Load");
      EXPECT_EQ(sumOfFractions(points), 1.0) << n;
      EXPECT_NEAR(resultant(body, points)[1], 0.5 * n, 1.0e-13 * n);
    }
  }
}

/// Half of a 4 m line hangs over the end of a 2 m body: of 8 points the last, beyond 1.414 m of (1.5, 0.5),
/// miss: those at 3.25 and 3.75 (the one at 2.75 is 1.35 m away).
TEST(LoadPoints, CountsThePointsThatMiss)
{
  const auto message = errorOf(
      [] {
        lineLoad<2>(sheet(2, 1), {{0.0, 1.0}}, {{4.0, 1.0}}, Profile::Uniform, "Boundaries > Push");
      });
  EXPECT_EQ(message.find(
                "Boundaries > Push: 2 of the load's 8 points miss the body; the first of them, (3.25, 1) m"),
            0u)
      << message;
  EXPECT_NE(errorOf(
                [] {
                  lineLoad<2>(sheet(2, 1), {{9, 9}}, {{9, 8}}, Profile::Uniform, "Push");
                })
                .find("none of its 2 points"),
            std::string::npos);
}

TEST(LoadPoints, LineWithoutLengthIsAnError)
{
  EXPECT_THROW(lineLoad<2>(sheet(2, 1), {{0, 1}}, {{0, 1}}, Profile::Uniform, "Push"), std::invalid_argument);
}

/// The 2 m x 3 m top of a block: 4 x 6 points of 1/24, resultant in its middle.
TEST(LoadPoints, FaceOfABlock)
{
  const auto body = block(2, 3, 2);
  const auto points = faceLoad(body, {{0, 0, 2}}, {{2, 0, 0}}, {{0, 3, 0}}, "Load");
  ASSERT_EQ(points.size(), 24u);
  EXPECT_DOUBLE_EQ(points[0].fraction, 1.0 / 24.0);
  EXPECT_EQ(points[0].particle, 6); // first of the upper layer
  EXPECT_DOUBLE_EQ(points[0].offset[2], 0.5);
  EXPECT_EQ(sumOfFractions(points), 1.0);
  const auto middle = resultant(body, points);
  EXPECT_NEAR(middle[0], 1.0, 1.0e-15);
  EXPECT_NEAR(middle[1], 1.5, 2.0e-15);
  EXPECT_NEAR(middle[2], 2.0, 2.0e-15);
  EXPECT_THROW(faceLoad(body, {{0, 0, 2}}, {{2, 0, 0}}, {{-1, 0, 0}}, "Load"), std::invalid_argument);
}

/// Against a search over all points, at random positions around the origin (negative coordinates too).
template <int D>
void compareWithFullSearch()
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  std::vector<Vector<D>> points(500);
  for (auto& x : points)
    for (int d = 0; d < D; ++d)
      x[d] = coordinate(random);
  const double reach = 0.2;
  const NearestPoint<D> nearest(points, reach);
  int found = 0;
  for (int n = 0; n < 500; ++n)
  {
    Vector<D> x;
    for (int d = 0; d < D; ++d)
      x[d] = 1.2 * coordinate(random);
    int expected = -1;
    double best = reach;
    for (int p = 0; p < 500; ++p)
      if (norm(x - points[p]) < best)
      {
        best = norm(x - points[p]);
        expected = p;
      }
    EXPECT_EQ(nearest.find(x), expected);
    found += expected >= 0;
  }
  EXPECT_GT(found, 100); // both outcomes were tried
  EXPECT_LT(found, 500);
}

TEST(NearestPoint, AgreesWithAFullSearchIn2D) { compareWithFullSearch<2>(); }
TEST(NearestPoint, AgreesWithAFullSearchIn3D) { compareWithFullSearch<3>(); }
