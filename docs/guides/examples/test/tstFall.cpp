/// A test with a closed form and a tolerance that is derived: docs/how-to/add-a-test.md.

#include <Simulation.hpp>
#include <plan/EffectSchema.hpp>
#include <scene/Scene.hpp>

#include <Teuchos_DefaultMpiComm.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace Rhegma;

namespace
{

constexpr double gravity = 10.0, end = 1.0e-2;

/// A block that falls freely, with nothing else in the scene.
const char* const scene = R"xml(<ParameterList name="Rhegma">
  <ParameterList name="Domain">
    <Parameter name="Dimension" type="int" value="2"/>
    <Parameter name="Lower Corner" type="Array(double)" value="{0, 0}"/>
    <Parameter name="Upper Corner" type="Array(double)" value="{0.1, 0.1}"/>
    <Parameter name="Cell Size" type="double" value="0.01"/>
  </ParameterList>
  <ParameterList name="Time"><Parameter name="Final Time" type="double" value="1e-2"/></ParameterList>
  <ParameterList name="Materials">
    <ParameterList name="Rubber">
      <Parameter name="Model" type="string" value="Neo-Hookean"/>
      <Parameter name="Density" type="double" value="1000"/>
      <Parameter name="Young Modulus" type="double" value="1e6"/>
      <Parameter name="Poisson Ratio" type="double" value="0.3"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Bodies">
    <ParameterList name="Block">
      <Parameter name="Material" type="string" value="Rubber"/>
      <Parameter name="Shape" type="string" value="Box"/>
      <Parameter name="Lower Corner" type="Array(double)" value="{0.03, 0.03}"/>
      <Parameter name="Upper Corner" type="Array(double)" value="{0.06, 0.06}"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Boundaries">
    <ParameterList name="Weight">
      <Parameter name="Type" type="string" value="Gravity"/>
      <Parameter name="Acceleration" type="Array(double)" value="{0, -10}"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Output"><Parameter name="Fields" type="bool" value="false"/></ParameterList>
</ParameterList>
)xml";

/// v = g t; x lags behind g t^2 / 2 by half a step, since force and motion alternate.
TEST(Fall, IsUniformlyAccelerated)
{
  const SceneResult result = readSceneText(scene, {}, effectSchema());
  ASSERT_TRUE(result.errors.empty()) << toString(result.errors[0]);
  Simulation simulation(Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD)), result.list);
  simulation.initialize();
  const double dt = simulation.stableTimeStep();
  simulation.advance(end);
  const auto v = simulation.particleField(fields::velocity).values;
  const auto x = simulation.particleField(fields::position).values;
  const auto X = simulation.particleField(fields::reference).values;
  // Every step rounds a sum over some ten nodes.
  const double round = 20.0 * (end / dt) * std::numeric_limits<double>::epsilon();
  EXPECT_NEAR(v[1] / (-gravity * end), 1.0, round);
  EXPECT_NEAR(x[1] - X[1], -0.5 * gravity * end * end, gravity * end * dt);
}

} // namespace
