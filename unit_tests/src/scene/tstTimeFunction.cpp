#include "scene/TimeFunction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

using Rhegma::TimeFunction;

namespace
{

void expectRefused(const std::string& text, const std::string& piece)
{
  try
  {
    TimeFunction::parse(text);
    ADD_FAILURE() << "accepted: " << text;
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_NE(std::string(error.what()).find(piece), std::string::npos) << error.what();
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
  }
}

} // namespace

TEST(TimeFunction, Constant) { EXPECT_EQ(TimeFunction::parse(" 2.5 ")(17.0), 2.5); }

TEST(TimeFunction, Expression)
{
  const auto f = TimeFunction::parse("3*sin(2*pi*50*t) + t^2");
  const double pi = std::acos(-1.0);
  for (const double t : {0.0, 1e-3, 0.7})
    // Few operations on numbers below 4; the sine's argument of up to 220 carries 220 roundings of its own
    // size.
    EXPECT_NEAR(f(t), 3.0 * std::sin(2.0 * pi * 50.0 * t) + t * t, 1e-12);
}

TEST(TimeFunction, Condition)
{
  const auto f = TimeFunction::parse("t < 1e-3 ? 1 : 0");
  EXPECT_EQ(f(0.0), 1.0);
  EXPECT_EQ(f(2e-3), 0.0);
  EXPECT_EQ(TimeFunction::parse("t == 1 || t >= 3")(3.0), 1.0);
}

TEST(TimeFunction, TableIsLinearBetweenAndConstantOutside)
{
  const auto f = TimeFunction::parse("1:0, 3:4,4:-2");
  EXPECT_EQ(f(0.0), 0.0);
  EXPECT_EQ(f(1.0), 0.0);
  EXPECT_EQ(f(2.0), 2.0);
  EXPECT_EQ(f(3.0), 4.0);
  EXPECT_EQ(f(3.5), 1.0);
  EXPECT_EQ(f(4.0), -2.0);
  EXPECT_EQ(f(1e9), -2.0);
}

/// A table is taken over a step exactly, wherever its corners are; an expression in the middle.
TEST(TimeFunction, OfATableLosesNothingOverSteps)
{
  const TimeFunction pulse = TimeFunction::parse("0:0, 5:0, 5.005:1, 5.01:0");
  EXPECT_EQ(pulse.corners().size(), 4u);
  EXPECT_NEAR(pulse.overStep(4.95, 5.05), 0.05, 1e-12); // 5 ms in 100 ms
  EXPECT_NEAR(pulse.overStep(5.0, 5.005), 0.5, 1e-12);
  EXPECT_EQ(pulse.overStep(6.0, 7.0), 0.0);
  double sum = 0.0;
  for (int k = 0; k < 7; ++k)
    sum += 10.0 / 7.0 * pulse.overStep(10.0 * k / 7.0, 10.0 * (k + 1) / 7.0);
  EXPECT_NEAR(sum, 0.005, 1e-12);
  const TimeFunction square = TimeFunction::parse("t*t");
  EXPECT_TRUE(square.corners().empty());
  EXPECT_EQ(square.overStep(1.0, 3.0), 4.0);
}

TEST(TimeFunction, OnePairIsAConstant)
{
  const auto f = TimeFunction::parse("0:7");
  EXPECT_EQ(f(-1.0), 7.0);
  EXPECT_EQ(f(1.0), 7.0);
}

TEST(TimeFunction, CopiesOutliveTheOriginal)
{
  std::vector<TimeFunction> functions;
  for (int i = 0; i < 50; ++i)
    functions.push_back(TimeFunction::parse(std::to_string(i) + "*t"));
  for (int i = 0; i < 50; ++i)
    EXPECT_EQ(functions[i](2.0), 2.0 * i);
}

TEST(TimeFunction, RefusesBadExpressions)
{
  expectRefused("", "empty");
  expectRefused("  ", "empty");
  expectRefused("sin(x)", "\"x\"");
  expectRefused("2*", "not a function of time");
  expectRefused("(t", "not a function of time");
  expectRefused("t = 3", "\"==\"");
  expectRefused("t += 3", "=");
  expectRefused("1, 2", "2 values");
  expectRefused("\"text\"", "not a function of time");
}

TEST(TimeFunction, RefusesBadTables)
{
  expectRefused("0:0, 0:1", "must increase");
  expectRefused("1:0, 0:1", "0 s follows 1 s");
  expectRefused("0:0, 1", "\"1\"");
  expectRefused("0:0,", "pair");
  expectRefused("0:a", "\"0:a\"");
  expectRefused("0:nan", "not finite");
  expectRefused("0:0:0", "pair");
}

/// A support that moves by a velocity of time moves as far in one step of equilibrium as in the steps of a
/// motion.
TEST(TimeFunction, MeanOfAShortPulse)
{
  const auto pulse = TimeFunction::parse("t < 2e-5 ? 1 - cos(2*pi*t/2e-5) : 0");
  EXPECT_NEAR(1e-3 * pulse.mean(0.0, 1e-3), 2e-5, 2e-5 * 1e-7);
  const auto table = TimeFunction::parse("0:0, 1e-5:2, 2e-5:0");
  EXPECT_NEAR(1e-3 * table.mean(0.0, 1e-3), 2e-5, 2e-5 * 1e-12);
}
