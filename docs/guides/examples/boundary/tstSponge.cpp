#include "Sponge.hpp"

#include <Simulation.hpp>
#include <plan/EffectSchema.hpp>
#include <scene/Scene.hpp>

#include <Teuchos_DefaultMpiComm.hpp>

#include <gtest/gtest.h>

#include <cmath>

using namespace Rhegma;

namespace
{

constexpr double rate = 1.0e3, speed = 1.0, end = 1.0e-3;

/// A block that flies through a sponge which covers the domain. \param upper right end of the sponge [m]
std::string scene(const std::string& upper, const std::string& analysis)
{
  return R"xml(<ParameterList name="Rhegma">
  <ParameterList name="Domain">
    <Parameter name="Dimension" type="int" value="2"/>
    <Parameter name="Lower Corner" type="Array(double)" value="{0, 0}"/>
    <Parameter name="Upper Corner" type="Array(double)" value="{0.1, 0.1}"/>
    <Parameter name="Cell Size" type="double" value="0.01"/>
  </ParameterList>
  <ParameterList name="Time">
    <Parameter name="Final Time" type="double" value="1e-3"/>
    <Parameter name="Analysis" type="string" value=")xml" +
         analysis + R"xml("/>
  </ParameterList>
  <ParameterList name="Materials">
    <ParameterList name="Rubber">
      <Parameter name="Model" type="string" value="Neo-Hookean"/>
      <Parameter name="Density" type="double" value="1000"/>
      <Parameter name="Young Modulus" type="double" value="1e7"/>
      <Parameter name="Poisson Ratio" type="double" value="0.3"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Bodies">
    <ParameterList name="Block">
      <Parameter name="Material" type="string" value="Rubber"/>
      <Parameter name="Shape" type="string" value="Box"/>
      <Parameter name="Lower Corner" type="Array(double)" value="{0.03, 0.03}"/>
      <Parameter name="Upper Corner" type="Array(double)" value="{0.06, 0.06}"/>
      <Parameter name="Velocity" type="Array(double)" value="{1, 0}"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Boundaries">
    <ParameterList name="Slow">
      <Parameter name="Type" type="string" value="Sponge"/>
      <Parameter name="Lower Corner" type="Array(double)" value="{-0.1, -0.1}"/>
      <Parameter name="Upper Corner" type="Array(double)" value="{)xml" +
         upper + R"xml(, 0.2}"/>
      <Parameter name="Rate" type="double" value="1e3"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Output"><Parameter name="Fields" type="bool" value="false"/></ParameterList>
</ParameterList>
)xml";
}

/// The application's one line.
const bool added = (addBoundaryType(sponge()), true);

SceneResult read(const std::string& upper, const std::string& analysis = "Dynamic")
{
  return readSceneText(scene(upper, analysis), {}, effectSchema());
}

/// The block slows down as a whole: v = v0 exp(-rate t). A step takes (1 - rate dt), whose logarithm is off
/// by (rate dt)^2 / 2 to first order, at most rate^2 dt t / 2 in all.
TEST(Sponge, SlowsABlock)
{
  ASSERT_TRUE(added);
  const SceneResult result = read("0.2");
  ASSERT_TRUE(result.errors.empty()) << toString(result.errors[0]);
  Simulation simulation(Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD)), result.list);
  simulation.initialize();
  const double dt = simulation.stableTimeStep();
  simulation.advance(end);
  const double v = simulation.particleField(fields::velocity).values[0];
  EXPECT_LT(v, speed);
  EXPECT_NEAR(std::log(v / speed), -rate * end, rate * rate * dt * end);
}

/// A force so large that it, and not the wave speed, sets the step: 1 / rate, half of what is stable.
TEST(Sponge, LimitsTheStep)
{
  const SceneResult result = read("0.2");
  ASSERT_TRUE(result.errors.empty()) << toString(result.errors[0]);
  result.list->sublist("Boundaries").sublist("Slow").set("Rate", 1.0e8);
  Simulation simulation(Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD)), result.list);
  simulation.initialize();
  EXPECT_DOUBLE_EQ(simulation.stableTimeStep(), 1.0e-8);
}

TEST(Sponge, RefusesABoxWithoutWidth)
{
  const SceneResult result = read("-0.2");
  ASSERT_EQ(result.errors.size(), 1u);
  EXPECT_EQ(result.errors[0].where, "Boundaries > Slow > Upper Corner");
}

TEST(Sponge, IsForScenesThatMove)
{
  const SceneResult result = read("0.2", "Static");
  ASSERT_EQ(result.errors.size(), 1u);
  EXPECT_EQ(result.errors[0].where, "Boundaries > Slow");
}

TEST(Sponge, HasAName)
{
  EXPECT_EQ(boundaryType("Sponge").section.name, "Sponge");
  EXPECT_THROW(addBoundaryType(sponge()), std::invalid_argument); // there is one already
}

} // namespace
