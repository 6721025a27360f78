#include "ShapeLists.hpp"

#include "geometry/SurfaceChoice.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

using namespace Rhegma;
using namespace ShapeLists;
using Teuchos::ParameterList;

namespace
{

const double pi = std::acos(-1.0);
constexpr double piece = 0.05; // between points

template <int D>
using ChosenPoints = std::vector<Geometry::SurfacePoint<D>>;

template <int D>
ChosenPoints<D> choose(const ParameterList& list, const Geometry::SurfaceChoice<D>& choice = {})
{
  return Geometry::chosenPoints(makeShape<D>(list), choice, piece);
}

template <int D>
double areaOf(const ChosenPoints<D>& points)
{
  double area = 0.0;
  for (const auto& point : points)
    area += point.size;
  return area;
}

/// Integral of the position times the normal over a closed surface, over the dimension: the volume inside
/// (divergence theorem).
template <int D>
double volumeIn(const ChosenPoints<D>& points)
{
  double volume = 0.0;
  for (const auto& point : points)
    volume += point.size * dot(point.x, point.normal) / D;
  return volume;
}

template <int D>
Vector<D> sumOfNormals(const ChosenPoints<D>& points)
{
  Vector<D> sum{};
  for (const auto& point : points)
    sum = sum + point.size * point.normal;
  return sum;
}

ParameterList cylinder(const std::vector<double>& from, const std::vector<double>& to, double radius)
{
  ParameterList list = body("Cylinder");
  list.set("From", Teuchos::Array<double>(from));
  list.set("To", Teuchos::Array<double>(to));
  list.set("Radius", radius);
  return list;
}

void cutOrAdd(ParameterList& list, const std::string& name, const std::string& operation,
              const ParameterList& shape)
{
  ParameterList& one = list.sublist("Operations").sublist(name);
  one = shape;
  one.set("Operation", operation);
}

} // namespace

TEST(SurfaceChoice, AreasOfWholeShapesAreExact)
{
  ParameterList plate = box({0.3, -0.2}, {2.3, 1.3});
  plate.set("Rotation", 25.0);
  EXPECT_NEAR(areaOf(choose<2>(plate)), 7.0, 1e-12);
  EXPECT_NEAR(areaOf(choose<2>(ball({1.0, 2.0}, 0.7))), 2.0 * pi * 0.7, 1e-12);
  EXPECT_NEAR(areaOf(choose<2>(polygon({0.0, 0.0, 3.0, 0.0, 3.0, 4.0}))), 12.0, 1e-12);
  EXPECT_NEAR(areaOf(choose<3>(box({0.0, 0.0, 0.0}, {2.0, 1.5, 1.0}))), 13.0, 1e-12);
  EXPECT_NEAR(areaOf(choose<3>(ball({0.0, 1.0, 0.0}, 0.6))), 4.0 * pi * 0.36, 1e-12);
  EXPECT_NEAR(areaOf(choose<3>(cylinder({0.0, 0.0, 0.0}, {1.0, 2.0, 2.0}, 0.5))), 2.0 * pi * 0.5 * 3.5,
              1e-12);
  ParameterList prism = polygon({0.0, 0.0, 3.0, 0.0, 3.0, 4.0});
  prism.set("Bottom", 0.0);
  prism.set("Top", 0.5);
  EXPECT_NEAR(areaOf(choose<3>(prism)), 12.0 + 6.0, 1e-12);
}

/// A midpoint rule with n points along a circle has an error of (2 pi / n)^2 / 6 at most.
TEST(SurfaceChoice, PointsAndNormalsGiveTheVolumeInside)
{
  std::mt19937 engine(std::random_device{}());
  const auto seed = engine();
  engine.seed(seed);
  SCOPED_TRACE(seed);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int trial = 0; trial < 20; ++trial)
  {
    const double r = 0.5 + 0.5 * part(engine), x = part(engine), y = part(engine);
    EXPECT_NEAR(volumeIn(choose<2>(ball({x, y}, r))), pi * r * r, 1e-9);
    const auto surface = choose<3>(cylinder({x, y, 0.0}, {y, 0.0, 1.0 + x}, r));
    const double length = std::sqrt((x - y) * (x - y) + y * y + (1.0 + x) * (1.0 + x));
    EXPECT_NEAR(volumeIn(surface), pi * r * r * length, 1e-9 * length);
    EXPECT_LT(norm(sumOfNormals(surface)), 1e-9);
    // A plate with a round hole that misses its edges.
    ParameterList plate = box({0.0, 0.0}, {4.0, 3.0});
    plate.set("Rotation", 90.0 * part(engine));
    cutOrAdd(plate, "Hole", "Cut", ball({1.9 + 0.2 * x, 1.4 + 0.2 * y}, r));
    EXPECT_NEAR(volumeIn(choose<2>(plate)), 12.0 - pi * r * r, 1e-9);
  }
}

TEST(SurfaceChoice, OfAPartIsItsOwn)
{
  ParameterList plate = box({0.0, 0.0, 0.0}, {4.0, 3.0, 1.0});
  cutOrAdd(plate, "Hole", "Cut", cylinder({2.0, 1.5, -1.0}, {2.0, 1.5, 2.0}, 0.7));
  Geometry::SurfaceChoice<3> hole;
  hole.part = 1;
  // Rings at the edges of the hole count whole or not: a part of spacing over the length.
  EXPECT_NEAR(areaOf(choose<3>(plate, hole)), 2.0 * pi * 0.7, 2.0 * pi * 0.7 * piece);
  Geometry::SurfaceChoice<3> base;
  base.part = 0;
  const double holes = 2.0 * pi * 0.49;
  EXPECT_NEAR(areaOf(choose<3>(plate, base)), 24.0 + 14.0 - holes, 0.02 * holes);
  for (const auto& point : choose<3>(plate, hole))
    EXPECT_NEAR(std::hypot(point.x[0] - 2.0, point.x[1] - 1.5), 0.7, 1e-12);
}

TEST(SurfaceChoice, IsByBoxAndDirection)
{
  const ParameterList shaft = cylinder({0.0, 0.0, 0.0}, {0.0, 0.0, 5.0}, 0.5);
  Geometry::SurfaceChoice<3> choice;
  choice.facing = {{0.0, 0.0, 3.0}, false, 10.0};
  EXPECT_NEAR(areaOf(choose<3>(shaft, choice)), pi * 0.25, 1e-12);
  for (const auto& point : choose<3>(shaft, choice))
    EXPECT_DOUBLE_EQ(point.x[2], 5.0);
  choice.facing = {{0.0, 0.0, -1.0}, true, 10.0};
  EXPECT_NEAR(areaOf(choose<3>(shaft, choice)), 5.0 * pi, 1e-12);
  choice.box = {{-1.0, -1.0, 1.0}, {1.0, 1.0, 2.0}};
  EXPECT_NEAR(areaOf(choose<3>(shaft, choice)), pi, 1e-12);
  choice.facing->largestAngle = 0.0;
  EXPECT_NEAR(areaOf(choose<3>(shaft, choice)), pi, 1e-12);
  // The half of a ball that faces a direction.
  Geometry::SurfaceChoice<2> half;
  half.facing = {{1.0, 1.0}, false, 90.0};
  EXPECT_NEAR(areaOf(choose<2>(ball({3.0, 2.0}, 1.0), half)), pi, 2.0 * piece);
}

/// Where the surfaces of two parts coincide, each piece counts once.
TEST(SurfaceChoice, CountsCoincidingSurfacesOnce)
{
  ParameterList added = box({0.0, 0.0}, {2.0, 1.0});
  cutOrAdd(added, "More", "Add",
           box({1.0, 0.0}, {3.0, 1.0})); // overlaps; their upper and lower edges coincide
  EXPECT_NEAR(areaOf(choose<2>(added)), 8.0, piece);
  ParameterList cut = box({0.0, 0.0}, {2.0, 1.0});
  cutOrAdd(cut, "Less", "Cut", box({-1.0, 0.0}, {0.0, 1.0})); // touches it
  EXPECT_NEAR(areaOf(choose<2>(cut)), 6.0, 1e-12);
}
