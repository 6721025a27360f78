/// Functions of time that drive a run, and how long they change.

#include "scene/DrivingFunction.hpp"

#include "Scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace Rhegma;
using namespace Rhegma::SceneTests;

namespace
{

Changes changesOf(const std::string& text, bool ofRate = false)
{
  return {{{"Boundaries > Pull > History", text, ofRate}}, 4.0};
}

/// Between two times at which functions are looked at [s].
constexpr double piece = 4.0 / 4096.0;

} // namespace

TEST(Changes, OfConstantsAreNone)
{
  for (const char* text : {"0", "2.5", "t < 5 ? 1 : 2"})
  {
    EXPECT_EQ(changesOf(text).last(), 0.0) << text;
    EXPECT_EQ(changesOf(text).after(0.0).fraction, 0.0) << text;
  }
}

/// Of a plateau before the whole load, not of what follows a pulse.
TEST(Changes, EndWithTheLastOne)
{
  EXPECT_NEAR(changesOf("t < 1.5 ? 0.01 : 1").last(), 1.5, piece);
  EXPECT_NEAR(changesOf("0:0, 0.3:0.7, 2:0.7, 2.2:1").last(), 2.2, piece);
  EXPECT_NEAR(changesOf("t < 1 ? sin(20 * t) : 0").last(), 1.0, piece);
  EXPECT_NEAR(changesOf("t < 3.9 ? 0.3 : 1").last(), 3.9, piece);
  EXPECT_NEAR(changesOf("1 - exp(-10 * t)").last(), std::log(1000.0) / 10.0, 2.0 * piece);
  EXPECT_NEAR(changesOf("t < 1.5 ? 0.01 : 1").after(0.5).fraction, 0.99, 1e-12);
  EXPECT_EQ(changesOf("t < 1.5 ? 0.01 : 1").after(0.5).where, "Boundaries > Pull > History");
  EXPECT_EQ(changesOf("t < 1.5 ? 0.01 : 1").after(2.0).fraction, 0.0);
}

/// A change of less than a thousandth is not noticed.
TEST(Changes, ThatAreSmallDoNotCount)
{
  EXPECT_EQ(changesOf("t < 1.5 ? 1 : 1.0005").last(), 0.0);
  EXPECT_GT(changesOf("t < 1.5 ? 1 : 1.002").last(), 1.0);
}

/// There is no time at which they settle; others are waited for even so.
TEST(Changes, UpToTheEndHaveNoLastOne)
{
  for (const char* text : {"sin(20 * t)", "t", "0:0, 4:1", "0.1 + sin(0.1 * t)"})
  {
    EXPECT_EQ(changesOf(text).last(), 0.0) << text;
    EXPECT_GT(changesOf(text).after(1.0).fraction, 0.5) << text;
  }
  const Changes both({{"a", "sin(20 * t)"}, {"b", "t < 1 ? 0 : 1"}}, 4.0);
  EXPECT_NEAR(both.last(), 1.0, piece);
  EXPECT_EQ(both.after(2.0).where, "a");
}

/// A support that moves with a constant velocity never settles; one whose velocity ends does.
TEST(Changes, OfRatesAreThoseOfTheirIntegrals)
{
  EXPECT_EQ(changesOf("1", true).last(), 0.0);
  EXPECT_NEAR(changesOf("1", true).after(1.0).fraction, 0.75, 1e-9);
  EXPECT_TRUE(changesOf("1", true).after(1.0).ofRate);
  EXPECT_NEAR(changesOf("t < 1 ? 1 : 0", true).last(), 1.0, 2e-3);
}

TEST(DrivingFunctions, AreThoseOfTheScene)
{
  const auto result = read(goodScene());
  ASSERT_FALSE(result.list.is_null()) << all(result.errors);
  const auto found = drivingFunctions(*result.list, coreSchema());
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].where, "Boundaries > Pull > History");
  EXPECT_EQ(found[0].text, "1");
}

/// A support that does not move drives nothing.
TEST(DrivingFunctions, OfVelocitiesDriveByTheirIntegral)
{
  for (const bool moves : {false, true})
  {
    const std::string grip = "<ParameterList name=\"Grip\">" + parameter("Type", "string", "Velocity") +
                             parameter("Lower Corner", "Array(double)", "{0, 0}") +
                             parameter("Upper Corner", "Array(double)", "{1, 4}") +
                             parameter("Value", "Array(double)", moves ? "{0, 1}" : "{0, 0}") +
                             "</ParameterList>";
    const auto result = read(with("Boundaries", grip));
    ASSERT_FALSE(result.list.is_null()) << all(result.errors);
    const auto found = drivingFunctions(*result.list, coreSchema());
    ASSERT_EQ(found.size(), moves ? 2u : 1u);
    EXPECT_EQ(found[0].where, moves ? "Boundaries > Grip > History" : "Boundaries > Pull > History");
    EXPECT_EQ(found[0].ofRate, moves);
  }
}
