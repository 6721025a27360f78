#include "ShapeLists.hpp"

#include "geometry/SurfacePoints.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace Rhegma;
using namespace ShapeLists;
using Teuchos::ParameterList;

namespace
{

constexpr double spacing = 0.25;

/// All points of a shape: each between material behind it and none in front of it.
template <int D>
std::vector<Geometry::SurfacePoint<D>> pointsOn(const Shape<D>& shape)
{
  std::vector<Geometry::SurfacePoint<D>> all;
  for (std::size_t part = 0; part < shape.parts().size(); ++part)
    for (const auto& point : Geometry::surfacePoints(shape, part, spacing))
    {
      EXPECT_NEAR(norm(point.normal), 1.0, 1e-12);
      EXPECT_TRUE(shape.contains(point.x - 1e-6 * point.normal));
      EXPECT_FALSE(shape.contains(point.x + 1e-6 * point.normal));
      all.push_back(point);
    }
  return all;
}

/// None of the surface is far from them: a diagonal of the pattern and what cuts leave of it, at random
/// positions between inside and outside.
template <int D>
void expectAllOver(const ParameterList& list)
{
  const Shape<D> shape = makeShape<D>(list);
  const auto points = pointsOn(shape);
  std::mt19937 engine(3);
  const Geometry::Bounds<D> bounds = shape.bounds();
  const auto any = [&]
  {
    Vector<D> x;
    for (int d = 0; d < D; ++d)
      x[d] = std::uniform_real_distribution<double>(bounds.lower[d] - 0.5, bounds.upper[d] + 0.5)(engine);
    return x;
  };
  int found = 0;
  for (int trial = 0; trial < 300; ++trial)
  {
    Vector<D> in = any(), out = any();
    if (shape.contains(in) == shape.contains(out))
      continue;
    if (!shape.contains(in))
      std::swap(in, out);
    for (int halving = 0; halving < 50; ++halving)
    {
      const Vector<D> middle = 0.5 * (in + out);
      (shape.contains(middle) ? in : out) = middle;
    }
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& point : points)
      nearest = std::min(nearest, norm(point.x - in));
    EXPECT_LT(nearest, 1.5 * spacing) << in[0] << " " << in[1];
    ++found;
  }
  EXPECT_GT(found, 30);
}

/// A second shape of a body.
void operate(ParameterList& list, const std::string& operation, const ParameterList& shape)
{
  ParameterList& second = list.sublist("Operations").sublist("Second");
  second = shape;
  second.set("Operation", operation);
}

} // namespace

TEST(SurfacePoints, AreAllOverPlaneShapes)
{
  ParameterList plate = box({0.0, 0.0}, {3.0, 2.0});
  plate.set("Rotation", 25.0);
  expectAllOver<2>(plate);
  operate(plate, "Cut", ball({1.5, 1.0}, 0.7));
  expectAllOver<2>(plate);
  ParameterList wedge = polygon({0.0, 0.0, 3.0, 0.0, 0.5, 2.0});
  expectAllOver<2>(wedge);
  operate(wedge, "Add", box({2.0, -0.5}, {4.0, 0.5}));
  expectAllOver<2>(wedge);
}

TEST(SurfacePoints, AreAllOverSolids)
{
  ParameterList block = box({0.0, 0.0, 0.0}, {2.0, 1.5, 1.0});
  expectAllOver<3>(block);
  operate(block, "Cut", ball({0.0, 0.0, 0.0}, 0.8));
  expectAllOver<3>(block);
  ParameterList bar = body("Cylinder");
  bar.set("From", numbers({0.0, 0.0, 0.0}));
  bar.set("To", numbers({1.0, 2.0, 1.0}));
  bar.set("Radius", 0.6);
  expectAllOver<3>(bar);
  ParameterList prism = polygon({0.0, 0.0, 2.0, 0.0, 0.5, 2.0});
  prism.set("Bottom", 0.0);
  prism.set("Top", 1.0);
  expectAllOver<3>(prism);
}

/// The face at which two parts are added to each other is none.
TEST(SurfacePoints, AreNotWherePartsTouch)
{
  ParameterList list = box({0.0, 0.0}, {1.0, 1.0});
  operate(list, "Add", box({1.0, 0.0}, {2.0, 1.0}));
  for (const auto& point : pointsOn(makeShape<2>(list)))
    EXPECT_GT(std::abs(point.x[0] - 1.0), 1e-9);
}

/// The normal of a hole points into it.
TEST(SurfacePoints, OfAHoleLookIntoIt)
{
  ParameterList list = box({0.0, 0.0}, {4.0, 4.0});
  operate(list, "Cut", ball({2.0, 2.0}, 1.0));
  const Shape<2> shape = makeShape<2>(list);
  for (const auto& point : Geometry::surfacePoints(shape, 1, spacing))
    EXPECT_NEAR(dot(point.normal, point.x - Vector<2>{2.0, 2.0}), -1.0, 1e-9);
}
