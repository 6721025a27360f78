/// USF strains particles in the middle of a step.

#include "plan/EffectSchema.hpp"
#include "scene/Scene.hpp"
#include "step/Run.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

using namespace Rhegma;

namespace
{

Teuchos::RCP<Teuchos::ParameterList> scene(const std::string& path, const std::vector<std::string>& overrides)
{
  const SceneResult result =
      readScene(std::string(RHEGMA_SOURCE_DIR) + "/xml_inputs/" + path, overrides, effectSchema());
  for (const SceneError& error : result.errors)
    ADD_FAILURE() << toString(error);
  return result.list;
}

} // namespace

/// Under USF mass, force and velocity of one step must use one box: a box that grows by the strain in between
/// gave nodes at the rim a force without its mass, and 2 J out of 2e-4.
TEST(StrainFirst, CreatesNoEnergyAtTheRim)
{
  Rhegma::Run<2> run(*scene("examples/dcb.xml", {"Time:Update Scheme=USF"}));
  run.initialize();
  State<2>& state = run.state();
  while (state.clock.time < 4e-5)
    run.step(4e-5, false);
  const auto velocity = onHost(state.particles.real<2>(fields::velocity));
  const auto mass = onHost(state.particles.scalar(fields::mass));
  double kinetic = 0.0;
  for (std::size_t p = 0; p < mass.extent(0); ++p)
    kinetic += 0.5 * mass(p) * (velocity(p, 0) * velocity(p, 0) + velocity(p, 1) * velocity(p, 1));
  // The loads are the only source.
  EXPECT_GT(kinetic, 0.0);
  EXPECT_LE(kinetic, state.energy.externalWork);
}
