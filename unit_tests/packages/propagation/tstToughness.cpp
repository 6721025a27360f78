#include "propagation/Toughness.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

using namespace Rhegma::propagation;

namespace
{

std::string messageOf(const std::string& text)
{
  try
  {
    Toughness::parse(text).refuseWeak(1000.0);
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "";
}

bool says(const std::string& text, const std::string& words)
{
  return messageOf(text).find(words) != std::string::npos;
}

} // namespace

TEST(Toughness, IsANumberATableOrAnExpression)
{
  EXPECT_EQ(Toughness::parse("120")(300.0), 120.0);
  EXPECT_DOUBLE_EQ(Toughness::parse("100*(1 + v/500)")(250.0), 150.0);
  const Toughness table = Toughness::parse("0:100, 200:100, 400:300");
  EXPECT_EQ(table(100.0), 100.0);
  EXPECT_DOUBLE_EQ(table(300.0), 200.0);
  EXPECT_EQ(table(900.0), 300.0); // held constant outside
  EXPECT_DOUBLE_EQ(Toughness::parse("v < 100 ? 50 : 80")(500.0), 80.0);
}

TEST(Toughness, KnowsTheTemperatureWhereThereIsHeat)
{
  const Toughness toughness = Toughness::parse("100*(1 + v/500)*(1 - T/1000)", true);
  EXPECT_DOUBLE_EQ(toughness(250.0, 400.0), 90.0);
  EXPECT_NO_THROW(toughness.refuseWeak(1000.0, 300.0));
  EXPECT_THROW(toughness.refuseWeak(1000.0, 1000.0), std::invalid_argument);
}

TEST(Toughness, RefusesWhatIsNotPositive)
{
  EXPECT_TRUE(says("0", "is 0 J/m2 at v = 0"));
  EXPECT_TRUE(says("-5", "is -5 J/m2"));
  EXPECT_TRUE(says("100 - v", "at v = 100 m/s"));
  EXPECT_TRUE(says("1/v", "at v = 0"));
  EXPECT_EQ(messageOf("0:100, 500:200"), "");
}

TEST(Toughness, RefusesWhatIsNoFunctionOfSpeed)
{
  EXPECT_TRUE(says("100*(1 + speed)", "speed"));
  EXPECT_TRUE(says("100*(1 + T/300)", "depends on the temperature T"));
  EXPECT_TRUE(says("100 +", "is not a valid toughness"));
  EXPECT_TRUE(says("1, 2", "2 values instead of one"));
  EXPECT_TRUE(says("0:100, 0:200", "must increase"));
  EXPECT_TRUE(says("0:100, x:200", "not a pair"));
  EXPECT_TRUE(says("v = 3", "assigns"));
}
