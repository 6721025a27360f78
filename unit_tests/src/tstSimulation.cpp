/// End of a run, and settling.

#include "Simulation.hpp"
#include "base/OutputError.hpp"
#include "plan/EffectSchema.hpp"
#include "scene/Scene.hpp"

#include <Teuchos_DefaultMpiComm.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>
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

TEST(Simulation, ReadsScenesInUnits)
{
  const std::string file = std::string(RHEGMA_SOURCE_DIR) + "/xml_inputs/examples/dcb.xml";
  const auto scene = Simulation::readScene(file, {"Time:Maximum Steps=3", "Time:Final Time=8 ms"});
  EXPECT_EQ(scene->sublist("Time").get<double>("Final Time"), 8e-3);
  Simulation simulation(Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD)), scene);
  simulation.initialize();
  simulation.advance(8e-3);
  EXPECT_EQ(simulation.steps(), 3);
  try
  {
    Simulation::readScene(file, {"Time:Final Time=8 MPa", "Time:CFL=-1"});
    FAIL() << "a wrong scene was read";
  }
  catch (const std::invalid_argument& error)
  {
    const std::string message = error.what();
    EXPECT_NE(message.find("Time > Final Time: is given in MPa"), std::string::npos) << message;
    EXPECT_NE(message.find("\nTime > CFL: "), std::string::npos) << message;
  }
}

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

/// What no sample has measured is not a number in the report; what every step records is one.
TEST(Simulation, ReportsNoNumberThatItHasNotMeasured)
{
  for (const bool sampled : {false, true})
  {
    Simulation simulation = example("dcb.xml", {});
    const nlohmann::json before = simulation.report();
    EXPECT_EQ(before["energy"]["strain"].get<double>(), 0.0); // at the start
    if (sampled)
      simulation.sampleEvery(1.0, [](double, const Simulation::Row&) {});
    simulation.advance(2.0e-5);
    const nlohmann::json report = simulation.report();
    for (const char* name : {"kinetic", "strain", "residual"})
      EXPECT_EQ(std::isfinite(report["energy"][name].get<double>()), sampled) << name;
    EXPECT_EQ(std::isfinite(report["momentum"][0].get<double>()), sampled);
    EXPECT_GT(report["energy"]["external_work"].get<double>(), 0.0);
    const nlohmann::json& front = report["cracks"][0]["fronts"][0];
    EXPECT_EQ(std::isfinite(front["G_J"].get<double>()), sampled);
    ASSERT_FALSE(report["boundaries"].empty());
    for (const auto& boundary : report["boundaries"])
      EXPECT_EQ(std::isfinite(boundary["force"][0].get<double>()), sampled) << boundary["name"];
  }
}

/// Tolerances that any sample meets: settled after two samples. The run ends there only if the scene requests
/// it.
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

/// Settling uses the energy release rates of the same sample, so they are computed first.
TEST(Simulation, SettlesByWhatCracksRelease)
{
  const std::string plan = example("dcb.xml", {}).plan();
  const auto settling = plan.find("    settling: ");
  ASSERT_NE(settling, std::string::npos);
  EXPECT_LT(plan.find("    energy release of crack fronts: "), settling);
}

/// A strip under tension: its ends move by 3 % of a cell into cells that were empty, whose nodes then have
/// 1e-3 of their neighbours' mass and 3 % of the stress. A load without them never settles, and a quarter of
/// its work is lost; the step's own error, with the energies half a step apart, is 0.7 %.
TEST(Simulation, RestsUnderALoadOnAFaceThatMovesIntoEmptyCells)
{
  Simulation simulation = example("edge_crack.xml", {"Domain:Cell Size=2.5e-3"});
  simulation.sampleEvery(5.0e-6, [](double, const Simulation::Row&) {});
  simulation.advance(1.0e-3);
  EXPECT_TRUE(simulation.settled());
  const auto energy = simulation.report()["energy"];
  EXPECT_LT(std::abs(energy["residual"].get<double>()), 0.01 * energy["external_work"].get<double>());
}

namespace
{

/// Sum over the particles of a field per undeformed volume.
double overVolume(const Simulation& simulation, const std::string& field)
{
  const std::vector<double> values = simulation.particleField(field).values;
  const std::vector<double> volumes = simulation.particleField(fields::volume).values;
  double sum = 0.0;
  for (std::size_t p = 0; p < volumes.size(); ++p)
    sum += values[p] * volumes[p];
  return sum;
}

double sampled(const Simulation& simulation, const std::string& name)
{
  for (const auto& [key, value] : simulation.observe())
    if (key == name)
      return value;
  ADD_FAILURE() << "no column " << name;
  return 0.0;
}

} // namespace

TEST(Simulation, CopiesFieldsOfItsParticles)
{
  Simulation simulation = example("dcb.xml", {});
  const ParticleCopy position = simulation.particleField(fields::position);
  EXPECT_EQ(position.field.components, 2);
  EXPECT_EQ(position.field.unit, "m");
  ASSERT_EQ(position.particles, simulation.particles());
  ASSERT_EQ(static_cast<int>(position.values.size()), 2 * simulation.particles());
  // Nothing has moved yet; each particle has its own number.
  EXPECT_EQ(position.values, simulation.particleField(fields::reference).values);
  std::vector<double> ids = simulation.particleField(fields::id).values;
  std::sort(ids.begin(), ids.end());
  for (std::size_t p = 0; p < ids.size(); ++p)
    ASSERT_EQ(ids[p], p);
  EXPECT_THROW(simulation.particleField("colour"), std::invalid_argument);
  for (const std::string& name : simulation.particleFields())
    EXPECT_EQ(simulation.particleField(name).particles, simulation.particles()) << name;
}

/// A hot spot that conducts only: what is given is what they hold more, and what the energy balance has, to
/// round-off.
TEST(Simulation, GivesHeatToItsParticles)
{
  Simulation simulation = example("hot_spot.xml", {"Thermal:Sources:Torch:Power=0"});
  simulation.sampleEvery(1.0, [](double, const Simulation::Row&) {});
  std::vector<double> joules(simulation.particles());
  double given = 0.0, turnover = 0.0;
  for (std::size_t p = 0; p < joules.size(); ++p)
  {
    joules[p] = 1e-9 * (p % 7) - 1e-9 * (p % 5);
    given += joules[p];
    turnover += std::abs(joules[p]);
  }
  const double before = overVolume(simulation, fields::internalEnergy);
  const std::vector<double> cold = simulation.particleField(fields::temperature).values;
  simulation.giveHeat(joules);
  const double roundOff = 1e-12 * (turnover + std::abs(before));
  EXPECT_NEAR(overVolume(simulation, fields::internalEnergy) - before, given, roundOff);
  const std::vector<double> warm = simulation.particleField(fields::temperature).values;
  for (std::size_t p = 0; p < joules.size(); ++p)
    ASSERT_EQ(warm[p] > cold[p], joules[p] > 0.0);
  simulation.advance(simulation.stableTimeStep());
  EXPECT_NEAR(sampled(simulation, "heat"), given, roundOff);

  joules.pop_back();
  EXPECT_THROW(simulation.giveHeat(joules), std::invalid_argument);
  joules.push_back(std::nan(""));
  EXPECT_THROW(simulation.giveHeat(joules), std::invalid_argument);
  Simulation without = example("dcb.xml", {});
  EXPECT_THROW(without.giveHeat(std::vector<double>(without.particles())), std::invalid_argument);
}

/// An application that goes on from a checkpoint does not lose what it can't continue before it knows of it.
TEST(Simulation, KeepsFieldsThatItCannotContinue)
{
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("rhegma-fields-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  const std::string path = folder / "fields.h5", checkpoint = folder / "checkpoint.h5";
  Simulation before = example("dcb.xml", {});
  before.writeFields(folder);
  before.checkpoint(checkpoint);
  const auto restored = [&checkpoint]
  {
    const SceneResult result =
        readScene(std::string(RHEGMA_SOURCE_DIR) + "/xml_inputs/examples/dcb.xml", {}, effectSchema());
    Simulation simulation(Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD)), result.list);
    simulation.restore(checkpoint);
    return simulation;
  };
  std::ofstream(path) << "damaged";
  Simulation after = restored();
  EXPECT_THROW(after.writeFields(folder), OutputError);
  EXPECT_EQ(std::filesystem::file_size(path), 7u);
  after.writeFields(folder); // the application insists
  EXPECT_GT(std::filesystem::file_size(path), 7u);
  std::ofstream(path) << "damaged";
  std::string why;
  Simulation asked = restored();
  EXPECT_FALSE(asked.continueFields(folder, &why));
  EXPECT_NE(why, "");
  EXPECT_NO_THROW(asked.writeFields(folder));
  // Where there is none, new fields begin.
  std::filesystem::remove(path);
  EXPECT_NO_THROW(restored().writeFields(folder));
  EXPECT_TRUE(std::filesystem::exists(path));
  std::filesystem::remove_all(folder);
}
