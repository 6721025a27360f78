#include "ShapeLists.hpp"

#include "geometry/Shape.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

using Rhegma::makeShape;
using Rhegma::Vector;
using namespace ShapeLists;
using Teuchos::ParameterList;

namespace
{

/// The message that makeShape throws.
template <int D>
std::string errorOf(const ParameterList& list)
{
  try
  {
    makeShape<D>(list);
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "";
}

} // namespace

TEST(Shape, BoxHoldsItsSurface)
{
  const auto shape = makeShape<2>(box({0.0, 0.0}, {2.0, 1.0}));
  EXPECT_TRUE(shape.contains({{1.0, 0.5}}));
  EXPECT_TRUE(shape.contains({{2.0, 1.0}}));
  EXPECT_FALSE(shape.contains({{2.001, 0.5}}));
  EXPECT_FALSE(shape.contains({{1.0, -0.001}}));
}

/// A 2 x 1 box turned by 90 degrees about its middle (1, 0.5) is a 1 x 2 box from (0.5, -0.5) to (1.5, 1.5).
TEST(Shape, TurnsAboutItsMiddle)
{
  auto list = box({0.0, 0.0}, {2.0, 1.0});
  list.set("Rotation", 90.0);
  const auto shape = makeShape<2>(list);
  EXPECT_TRUE(shape.contains({{1.0, 1.4}}));
  EXPECT_FALSE(shape.contains({{1.6, 0.5}}));
  const auto bounds = shape.bounds();
  EXPECT_DOUBLE_EQ(bounds.lower[0], 0.5);
  EXPECT_DOUBLE_EQ(bounds.lower[1], -0.5);
  EXPECT_DOUBLE_EQ(bounds.upper[0], 1.5);
  EXPECT_DOUBLE_EQ(bounds.upper[1], 1.5);
}

/// About the origin the same box covers x from -1 to 0 and y from 0 to 2: the turn is anticlockwise.
TEST(Shape, TurnsAnticlockwiseAboutAGivenCentre)
{
  auto list = box({0.0, 0.0}, {2.0, 1.0});
  list.set("Rotation", 90.0);
  list.set("Rotation Centre", numbers({0.0, 0.0}));
  const auto shape = makeShape<2>(list);
  EXPECT_TRUE(shape.contains({{-0.5, 1.5}}));
  EXPECT_FALSE(shape.contains({{0.5, 0.5}}));
}

/// A scene with defaults filled in contains empty arrays; they mean "not given".
TEST(Shape, TakesAnEmptyArrayForAbsent)
{
  auto list = box({0.0, 0.0}, {2.0, 1.0});
  list.set("Rotation", 90.0);
  list.set("Rotation Centre", Teuchos::Array<double>());
  EXPECT_TRUE(makeShape<2>(list).contains({{1.0, 1.4}}));
}

/// Turned by 90 degrees about x, the side along y points along z.
TEST(Shape, TurnsAboutAnAxisIn3D)
{
  auto list = box({0.0, 0.0, 0.0}, {1.0, 4.0, 1.0});
  list.set("Rotation", 90.0);
  list.set("Rotation Centre", numbers({0.0, 0.0, 0.0}));
  list.set("Rotation Axis", numbers({2.0, 0.0, 0.0})); // of any length
  const auto shape = makeShape<3>(list);
  EXPECT_TRUE(shape.contains({{0.5, -0.5, 3.5}}));
  EXPECT_FALSE(shape.contains({{0.5, 3.5, 0.5}}));
  const auto bounds = shape.bounds();
  EXPECT_NEAR(bounds.lower[1], -1.0, 1.0e-15);
  EXPECT_NEAR(bounds.upper[2], 4.0, 4.0e-15);
}

/// The distance from (1, 1) to (4, 5) is 5.
TEST(Shape, BallIsADiskIn2D)
{
  EXPECT_TRUE(makeShape<2>(ball({1.0, 1.0}, 5.0)).contains({{4.0, 5.0}}));
  EXPECT_FALSE(makeShape<2>(ball({1.0, 1.0}, 4.99)).contains({{4.0, 5.0}}));
}

/// A turned ball is the same ball, and its bounds are no larger.
TEST(Shape, BoundsOfATurnedBallAreTight)
{
  auto list = ball({1.0, 2.0, 3.0}, 0.5);
  list.set("Rotation", 45.0);
  const auto bounds = makeShape<3>(list).bounds();
  for (int d = 0; d < 3; ++d)
  {
    EXPECT_NEAR(bounds.lower[d], d + 0.5, 1.0e-15);
    EXPECT_NEAR(bounds.upper[d], d + 1.5, 1.0e-15);
  }
}

/// Axis along (3, 4, 0) / 5: the end disks of radius 1 reach 4/5 along x, 3/5 along y and 1 along z.
TEST(Shape, CylinderAlongAnInclinedAxis)
{
  ParameterList list("Pin");
  list.set<std::string>("Shape", "Cylinder");
  list.set("From", numbers({0.0, 0.0, 0.0}));
  list.set("To", numbers({3.0, 4.0, 0.0}));
  list.set("Radius", 1.0);
  const auto shape = makeShape<3>(list);
  EXPECT_TRUE(shape.contains({{1.5, 2.0, 0.99}}));
  EXPECT_FALSE(shape.contains({{1.5, 2.0, 1.01}}));
  EXPECT_FALSE(shape.contains({{3.1, 4.1, 0.0}})); // past the flat end, in a ball's reach
  const auto bounds = shape.bounds();
  EXPECT_DOUBLE_EQ(bounds.lower[0], -0.8);
  EXPECT_DOUBLE_EQ(bounds.upper[1], 4.6);
  EXPECT_DOUBLE_EQ(bounds.upper[2], 1.0);
}

/// An L: the notch at the upper right is outside, also for a clockwise outline that repeats its first point.
TEST(Shape, PolygonWithAReentrantCorner)
{
  const auto shape = makeShape<2>(polygon({0, 0, 2, 0, 2, 1, 1, 1, 1, 2, 0, 2}));
  EXPECT_TRUE(shape.contains({{1.5, 0.5}}));
  EXPECT_TRUE(shape.contains({{0.5, 1.5}}));
  EXPECT_TRUE(shape.contains({{1.0, 1.5}})); // on an edge
  EXPECT_FALSE(shape.contains({{1.5, 1.5}}));
  EXPECT_FALSE(shape.contains({{-0.5, 1.0}})); // level with a vertex

  const auto clockwise = makeShape<2>(polygon({0, 0, 0, 2, 1, 2, 1, 1, 2, 1, 2, 0, 0, 0}));
  EXPECT_TRUE(clockwise.contains({{0.5, 1.5}}));
  EXPECT_FALSE(clockwise.contains({{1.5, 1.5}}));
}

TEST(Shape, PolygonIsAPrismIn3D)
{
  auto list = polygon({0, 0, 1, 0, 0, 1});
  list.set("Bottom", -1.0);
  list.set("Top", 2.0);
  const auto shape = makeShape<3>(list);
  EXPECT_TRUE(shape.contains({{0.25, 0.25, 1.9}}));
  EXPECT_FALSE(shape.contains({{0.25, 0.25, 2.1}}));
  EXPECT_FALSE(shape.contains({{0.75, 0.75, 0.0}}));
  EXPECT_DOUBLE_EQ(shape.bounds().lower[2], -1.0);
}

/// A hole is cut and a plug put back into it: the last operation that reaches a point decides.
TEST(Shape, AddsAndCutsInOrder)
{
  auto list = box({-2.0, -2.0}, {2.0, 2.0});
  auto& operations = list.sublist("Operations");
  operations.sublist("Hole") = ball({0.0, 0.0}, 1.0);
  operations.sublist("Hole").set<std::string>("Operation", "Cut");
  operations.sublist("A plug") = ball({0.0, 0.0}, 0.5);
  operations.sublist("A plug").set<std::string>("Operation", "Add");
  const auto shape = makeShape<2>(list);
  EXPECT_TRUE(shape.contains({{0.0, 0.0}}));
  EXPECT_FALSE(shape.contains({{0.75, 0.0}}));
  EXPECT_TRUE(shape.contains({{1.5, 0.0}}));
}

TEST(Shape, BoundsGrowWithWhatIsAdded)
{
  auto list = box({0.0, 0.0}, {1.0, 1.0});
  list.sublist("Operations").sublist("Knob") = ball({1.0, 0.5}, 0.25);
  list.sublist("Operations").sublist("Knob").set<std::string>("Operation", "Add");
  list.sublist("Operations").sublist("Bite") = ball({0.0, 0.5}, 0.25);
  list.sublist("Operations").sublist("Bite").set<std::string>("Operation", "Cut");
  const auto bounds = makeShape<2>(list).bounds();
  EXPECT_DOUBLE_EQ(bounds.lower[0], 0.0);
  EXPECT_DOUBLE_EQ(bounds.upper[0], 1.25);
}

TEST(Shape, NamesTheSectionOfAMistake)
{
  EXPECT_EQ(errorOf<2>(box({0.0, 0.0}, {1.0, 0.0})),
            "Bodies > Beam > Upper Corner: must lie above Lower Corner along y.");
  EXPECT_EQ(
      errorOf<3>(box({0.0, 0.0}, {1.0, 1.0})),
      "Bodies > Beam > Lower Corner: has 2 numbers; in 3D it must be 3 numbers (type=\"Array(double)\").");
  auto list = box({0.0, 0.0}, {1.0, 1.0});
  list.sublist("Operations").sublist("Hole") = ball({0.5, 0.5}, 0.1);
  list.sublist("Operations").sublist("Hole").setName("Rhegma->Bodies->Beam->Operations->Hole");
  list.sublist("Operations").sublist("Hole").set<std::string>("Operation", "Drill");
  const auto message = errorOf<2>(list);
  EXPECT_EQ(
      message,
      "Bodies > Beam > Operations > Hole > Operation: \"Drill\" is no operation; write one of Add, Cut.");
}

TEST(Shape, RefusesWhatHasNoVolume)
{
  EXPECT_NE(errorOf<2>(ball({0.0, 0.0}, 0.0)).find("Radius"), std::string::npos);
  EXPECT_NE(errorOf<2>(polygon({0, 0, 1, 1, 2, 2})).find("no area"), std::string::npos);
  EXPECT_NE(errorOf<2>(polygon({0, 0, 1, 1})).find("at least three points"), std::string::npos);
  EXPECT_NE(errorOf<2>(polygon({0, 0, 2, 1, 2, 0, 0, 2})).find("meets the edge"),
            std::string::npos); // bow tie
  EXPECT_NE(errorOf<2>(box({0.0, std::nan("")}, {1.0, 1.0})).find("not a number"), std::string::npos);
  EXPECT_NE(errorOf<3>(polygon({0, 0, 1, 0, 0, 1})).find("Bottom"), std::string::npos);

  ParameterList cylinder("Pin");
  cylinder.set<std::string>("Shape", "Cylinder");
  EXPECT_NE(errorOf<2>(cylinder).find("in 3D only"), std::string::npos);
  ParameterList none("Pin");
  EXPECT_NE(errorOf<2>(none).find("Pin > Shape: is missing"), std::string::npos);
}
