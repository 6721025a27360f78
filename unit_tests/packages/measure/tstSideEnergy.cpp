/// Energy of the body on both sides of a crack.

#include "measure/SideEnergy.hpp"
#include "plan/EffectSchema.hpp"
#include "scene/Scene.hpp"
#include "step/Run.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>

namespace Rhegma::measure
{

namespace
{

/// The bar with a joint across it at half of its height, as read; the mistakes of the scene.
SceneResult barScene(std::vector<std::string> overrides)
{
  overrides.push_back("Boundaries:Pulse:Stress={0, 0}");
  return readScene(std::string(RHEGMA_SOURCE_DIR) + "/xml_inputs/verification/contact_pulse_compressive.xml",
                   overrides, effectSchema());
}

std::unique_ptr<Run<2>> bar(const std::vector<std::string>& overrides = {})
{
  const SceneResult scene = barScene(overrides);
  for (const SceneError& error : scene.errors)
    ADD_FAILURE() << toString(error);
  auto run = std::make_unique<Run<2>>(*scene.list);
  run->initialize();
  return run;
}

/// Gives every particle a velocity, (along, across) above the joint and at rest below it. \return the mass
/// above
double moveAbove(State<2>& state, double along, double across)
{
  const auto position = onHost(state.particles.real<2>(fields::position));
  const auto velocity = onHost(state.particles.real<2>(fields::velocity));
  const auto mass = onHost(state.particles.scalar(fields::mass));
  double above = 0.0;
  for (int p = 0; p < state.particles.size(); ++p)
  {
    const bool moves = position(p, 1) > 0.04;
    velocity(p, 0) = moves ? along : 0.0;
    velocity(p, 1) = moves ? across : 0.0;
    above += moves ? mass(p) : 0.0;
  }
  Kokkos::deep_copy(state.particles.real<2>(fields::velocity), velocity);
  return above;
}

} // namespace

TEST(SideEnergy, CountsWhatMovesAbove)
{
  const auto run = bar();
  const double mass = moveAbove(run->state(), 3.0, 4.0);
  const SideEnergy energy = measureSides(run->state(), measuredCrack(run->state().cracks, 0, 1.0));
  EXPECT_GT(mass, 0.0);
  EXPECT_EQ(energy.below, 0.0);
  EXPECT_EQ(energy.alongBelow, 0.0);
  EXPECT_NEAR(energy.above, 12.5 * mass, 1e-12 * mass);
  EXPECT_NEAR(energy.alongAbove, 4.5 * mass, 1e-12 * mass);
}

/// Up to a millimetre from the middle of the bar, which is 4 mm wide.
TEST(SideEnergy, CountsThePartNextToTheMiddle)
{
  const auto run = bar();
  moveAbove(run->state(), 0.0, 1.0);
  const double all = measureSides(run->state(), measuredCrack(run->state().cracks, 0, 1.0)).above;
  const double length = measuredCrack(run->state().cracks, 0, 1.0).length;
  const double part = measureSides(run->state(), measuredCrack(run->state().cracks, 0, 2e-3 / length)).above;
  EXPECT_NEAR(part, 0.5 * all, 1e-9 * all);
}

TEST(SideEnergy, IsInTheReportOfTheEffect)
{
  const auto run = bar();
  nlohmann::json summary;
  for (const Effect<2>& effect : run->plan().effects)
    if (effect.name == "Measure")
      effect.report(run->state(), summary);
  // Nothing has been gained, so that there is nothing to have a fraction of.
  EXPECT_EQ(summary["cracks"][0]["contact"]["gain_above"], 0.0);
  EXPECT_TRUE(summary["cracks"][0]["contact"]["fraction_below"].is_null());
}

TEST(SideEnergy, AnOldParameterSaysItsNewPath)
{
  const SceneResult scene = readSceneText(
      "<ParameterList name=\"Rhegma\"><ParameterList name=\"Contact\"><Parameter name=\"Watched Part\" "
      "type=\"double\" value=\"0.5\"/></ParameterList></ParameterList>",
      {}, effectSchema());
  const auto says = [](const SceneError& error)
  { return toString(error).find("Measure > Side Energy > Part") != std::string::npos; };
  EXPECT_TRUE(std::any_of(scene.errors.begin(), scene.errors.end(), says));
}

} // namespace Rhegma::measure
