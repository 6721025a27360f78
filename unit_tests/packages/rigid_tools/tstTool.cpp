#include "rigid_tools/Tool.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace Rhegma::rigid_tools
{

namespace
{

Tool<2> disk(const std::string& history, double velocity, double spin = 0.0)
{
  Teuchos::ParameterList list;
  list.set<std::string>("Shape", "Ball");
  list.set("Centre", Teuchos::Array<double>(2, 0.0));
  list.set("Radius", 1.0);
  Teuchos::Array<double> speed(2, 0.0);
  speed[0] = velocity;
  list.set("Velocity", speed);
  list.set("Angular Velocity", Teuchos::Array<double>(1, spin));
  list.set("History", history);
  list.set<std::string>("Law", "Frictionless");
  return Tool<2>(list, "Disk");
}

Tool<2> mass(double kilograms, double force)
{
  Teuchos::ParameterList list;
  list.set<std::string>("Shape", "Ball");
  list.set("Centre", Teuchos::Array<double>(2, 0.0));
  list.set("Radius", 1.0);
  list.set("Velocity", Teuchos::Array<double>(2, 0.0));
  list.set("Angular Velocity", Teuchos::Array<double>(1, 0.0));
  list.set("Mass", kilograms);
  Teuchos::Array<double> push(2, 0.0);
  push[0] = force;
  list.set("Force", push);
  list.set<std::string>("Law", "Frictionless");
  return Tool<2>(list, "Weight");
}

} // namespace

/// No step takes a prescribed tool farther than it may go: from rest at time zero, at a jump of its history,
/// and by rotation about its middle (the ball around the square about a disk has the radius sqrt 2).
TEST(Tool, StepsAreAsShortAsItsMotionAsks)
{
  EXPECT_EQ(disk("1", 10.0).longestStep(0.0, 0.25, 1.0), 0.025);
  EXPECT_EQ(disk("1", 10.0).longestStep(0.0, 0.25, 1e-3), 1e-3);
  EXPECT_EQ(disk("1", 0.0).longestStep(0.0, 0.25, 1.0), 1.0);
  EXPECT_DOUBLE_EQ(disk("1", 0.0, 2.0).longestStep(0.0, 0.25, 1.0), 0.25 / (2.0 * std::sqrt(2.0)));
  const Tool<2> late = disk("0:0, 1:0, 1.001:1, 9:1", 1e4);
  for (double time = 0.0; time < 1.1;)
  {
    const double step = late.longestStep(time, 0.25, 0.3);
    ASSERT_GT(step, 1e-6);
    const TimeFunction history = TimeFunction::parse("0:0, 1:0, 1.001:1, 9:1");
    EXPECT_LE(1e4 * history.overStep(time, time + step) * step, 0.25 * (1.0 + 1e-12)) << time;
    time += step;
    if (time > 1.002)
      break;
  }
}

/// A mass that a force pushes from rest.
TEST(Tool, StepsOfAMassAreLimitedByItsForce)
{
  Tool<2> light = mass(1e-3, 100.0);
  const double step = light.longestStep(0.0, 0.25, 1.0);
  EXPECT_DOUBLE_EQ(step, std::sqrt(0.25 * 1e-3 / 100.0));
  light.beginStep(0.0, step);
  light.endStep(step);
  EXPECT_NEAR(light.middle()[0], 0.25, 1e-12);
  EXPECT_EQ(mass(1e6, 100.0).longestStep(0.0, 0.25, 1.0), 1.0);
}

} // namespace Rhegma::rigid_tools
