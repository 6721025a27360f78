/// Where a run ends, and that it can come to rest.

#include "Simulation.hpp"
#include "scene/Scene.hpp"
#include "step/EffectSchema.hpp"

#include <Teuchos_DefaultMpiComm.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

using namespace Rhegma;

namespace
{

Simulation example(const std::string& name, const std::vector<std::string>& overrides)
{
  const SceneResult result =
      readScene(std::string(RHEGMA_SOURCE_DIR) + "/xml_inputs/examples/" + name, overrides, effectSchema());
  for (const SceneError& error : result.errors)
    ADD_FAILURE() << toString(error);
  Simulation simulation(Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD)), result.list);
  simulation.initialize();
  return simulation;
}

} // namespace

TEST(Simulation, EndsAfterTheMaximumOfSteps)
{
  Simulation simulation = example("dcb.xml", {"Time:Maximum Steps=7"});
  int samples = 0;
  simulation.sampleEvery(1.0, [&samples](double, const Simulation::Row&) { ++samples; });
  simulation.advance(2.0e-6);
  EXPECT_FALSE(simulation.ended());
  simulation.advance(8.0e-3);
  EXPECT_TRUE(simulation.ended());
  EXPECT_FALSE(simulation.settled());
  EXPECT_EQ(simulation.steps(), 7);
  EXPECT_LT(simulation.time(), 8.0e-3);
  // After the first step, where the first advance ended, and at the end.
  EXPECT_EQ(samples, 3);
  simulation.advance(8.0e-3);
  EXPECT_EQ(simulation.steps(), 7);
}

/// Tolerances that any sample meets: settled as soon as there are two. The run ends there only if the scene
/// says so.
TEST(Simulation, EndsAtRestWhereTheSceneSaysSo)
{
  for (const std::string stop : {"true", "false"})
  {
    Simulation simulation =
        example("dcb.xml", {"Damping:Settled Energy Ratio=1e300", "Damping:Settled Drift=1e300",
                            "Damping:Settled Samples=2", "Damping:Stop When Settled=" + stop});
    simulation.sampleEvery(1.0e-5, [](double, const Simulation::Row&) {});
    simulation.advance(1.0e-4);
    EXPECT_TRUE(simulation.settled());
    EXPECT_EQ(simulation.ended(), stop == "true");
    EXPECT_EQ(simulation.time() == 1.0e-4, stop == "false") << simulation.time();
  }
}

/// Settling looks at the energy release rates of the same sample, so they come first.
TEST(Simulation, SettlesByWhatCracksRelease)
{
  EXPECT_NE(example("dcb.xml", {}).plan().find("energy release of crack fronts; settling"),
            std::string::npos);
}

/// A strip under tension: its ends move by 3 % of a cell into cells that were empty, whose nodes then have
/// 1e-3 of their neighbours' mass and carry 3 % of the stress. A load that leaves them out never comes to
/// rest, and a quarter of its work is lost; the step's own error, with the energies half a step apart, is 0.7
/// %.
TEST(Simulation, RestsUnderALoadOnAFaceThatMovesIntoEmptyCells)
{
  Simulation simulation = example("edge_crack.xml", {"Domain:Cell Size=2.5e-3"});
  simulation.sampleEvery(5.0e-6, [](double, const Simulation::Row&) {});
  simulation.advance(1.0e-3);
  EXPECT_TRUE(simulation.settled());
  const auto energy = simulation.report()["energy"];
  EXPECT_LT(std::abs(energy["residual"].get<double>()), 0.01 * energy["external_work"].get<double>());
}
