/// Burning cracks in bodies: what is conserved, how the flame spreads, how it ends.

#include "../../src/step/Bodies.hpp"
#include "state/EnergySums.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <stdexcept>

namespace Rhegma
{
namespace Test
{
namespace
{

/// A block with a crack in its middle, which ends in the middle of cells.
template <int D>
Teuchos::ParameterList burningBlock(bool toTheSurface)
{
  Teuchos::ParameterList scene = emptyScene<D>(all<D>(-2.0), all<D>(10.0), 1.0, "MUSL", "GIMP");
  addMaterial(scene, "Linear Elastic", 0.3);
  addBox<D>(scene, "Block", all<D>(0.0), all<D>(8.0));
  const double from = toTheSurface ? 0.0 : 2.5;
  Teuchos::Array<double> points;
  if (D == 2)
    points = Teuchos::tuple(from, 4.0, 5.5, 4.0);
  else
    points = Teuchos::Array<double>(
        std::vector<double>{from, 2.5, 4.0, 5.5, 2.5, 4.0, 5.5, 5.5, 4.0, from, 5.5, 4.0});
  scene.sublist("Cracks").sublist("Slit").set("Points", points);
  Teuchos::ParameterList& burning = scene.sublist("Combustion").sublist("Slit");
  burning.set("Burn Law", "Vieille");
  burning.set("Burn Coefficient", 1e-2);
  burning.set("Burn Exponent", 1.0);
  burning.set("Gas Constant", 1.0);
  burning.set("Flame Temperature", 1e-3);
  burning.set("Initial Temperature", 1e-3);
  burning.set("Initial Pressure", 1e-4);
  burning.set("Outside Pressure", 1e-5);
  burning.set("Initial Gap", 1e-2);
  return scene;
}

/// What the effects would add to summary.json.
template <int D>
nlohmann::json summaryOf(const Rhegma::Run<D>& run)
{
  nlohmann::json summary = nlohmann::json::object();
  for (const Effect<D>& effect : run.plan().effects)
    if (effect.report)
      effect.report(run.state(), summary);
  return summary;
}

template <int D>
void keepsMassMomentumAndEnergy(const std::string& model = "Uniform")
{
  Teuchos::ParameterList scene = burningBlock<D>(false);
  scene.sublist("Combustion").sublist("Slit").set("Gas Model", model);
  Rhegma::Run<D> run(validated(scene));
  run.initialize();
  State<D>& state = run.state();
  measureEnergy(state);
  const Vector<D> before = state.sample.momentum;
  const double startEnergy = state.energy.kinetic + state.energy.strain;
  // The energy balance of a body that moves oscillates by half a step's power of its stresses; its mean does
  // not.
  constexpr int samples = 16;
  double given = 0.0, open = 0.0;
  for (int k = 0; k < samples; ++k)
  {
    for (int n = 0; n < 25; ++n)
      run.step(1e9, n == 24);
    measureEnergy(state);
    given += (state.energy.kinetic + state.energy.strain - startEnergy) / samples;
    open += state.energy.residual() / samples;
  }
  const nlohmann::json summary = summaryOf(run);
  const nlohmann::json& crack = summary.at("cracks").at(0);
  EXPECT_GT(crack.at("burnt_mass").get<double>(), 0.0);
  EXPECT_GT(crack.at("pressure").get<double>(), 1e-4);
  EXPECT_NEAR(summary.at("combustion").at("mass_kept").get<double>(), 1.0, 1e-12);
  EXPECT_NEAR(crack.at("gas").at("energy_kept").get<double>(), 1.0, 1e-10);
  // The impulse that each face got.
  const double impulse = 1e-4 * (D == 2 ? 3.0 : 9.0) * state.clock.time;
  for (int d = 0; d < D; ++d)
    EXPECT_NEAR(state.sample.momentum[d], before[d], 1e-12 * impulse);
  EXPECT_GT(given, 0.0);
  std::printf("energy balance open by %+.2f %% of what was given\n", 100.0 * open / given);
  EXPECT_LT(std::fabs(open), 0.01 * given);
}

} // namespace

TEST(Burning, KeepsMassMomentumAndTheEnergyOfTheGasIn2D) { keepsMassMomentumAndEnergy<2>(); }
TEST(Burning, KeepsMassMomentumAndTheEnergyOfTheGasIn3D) { keepsMassMomentumAndEnergy<3>(); }

TEST(Burning, KeepsMassMomentumAndTheEnergyOfGasThatFlows) { keepsMassMomentumAndEnergy<2>("Flow"); }

/// Gas that flows fast through a crack that burns everywhere alike has one pressure, that of the uniform gas.
TEST(Burning, FlowsToTheUniformPressure)
{
  std::vector<double> pressure, burnt, lowest;
  for (const char* model : {"Uniform", "Flow"})
  {
    Teuchos::ParameterList scene = burningBlock<2>(false);
    Teuchos::ParameterList& burning = scene.sublist("Combustion").sublist("Slit");
    burning.set("Gas Model", model);
    // Sound takes a tenth of a second along the crack, and the pressure doubles in twenty.
    burning.set("Gas Constant", 1000.0);
    burning.set("Flame Temperature", 1.0);
    burning.set("Initial Temperature", 1.0);
    burning.set("Burn Coefficient", 2.5e-8);
    burning.set("Burn Exponent", 0.5);
    burning.set("Initial Gap", 0.1);
    Rhegma::Run<2> run(validated(scene));
    run.initialize();
    while (run.state().clock.time < 20.0 && run.state().failure.empty())
      run.step(20.0, false);
    ASSERT_EQ(run.state().failure, "");
    const nlohmann::json crack = summaryOf(run).at("cracks").at(0);
    pressure.push_back(crack.at("pressure").get<double>());
    burnt.push_back(crack.at("burnt_mass").get<double>());
    const nlohmann::json& gas = crack.at("gas");
    EXPECT_EQ(gas.contains("pressures"), std::string(model) == "Flow");
    if (gas.contains("pressures"))
    {
      for (const double p : gas.at("pressures").get<std::vector<double>>())
        // Sound of the beginning goes on between the ends: dp/dt times the tenth of a second, twice.
        EXPECT_NEAR(p, pressure[0], 1e-2 * pressure[0]);
    }
  }
  std::printf("pressure %.6g and %.6g, burnt %.6g and %.6g\n", pressure[0], pressure[1], burnt[0], burnt[1]);
  EXPECT_GT(pressure[0], 1.5e-4);
  EXPECT_NEAR(pressure[1], pressure[0], 2e-3 * pressure[0]);
  EXPECT_NEAR(burnt[1], burnt[0], 2e-3 * burnt[0]);
}

/// From one end of the crack, 3 m long: the area of both faces that burn is twice what the flame has passed,
/// to a face point of half a cell.
TEST(Burning, SpreadsWithTheFlame)
{
  Teuchos::ParameterList scene = burningBlock<2>(false);
  Teuchos::ParameterList& burning = scene.sublist("Combustion").sublist("Slit");
  burning.set("Ignition Point", Teuchos::Array<double>(Teuchos::tuple(2.5, 4.0)));
  burning.set("Flame Speed", 0.5);
  burning.set("Ignition Time", 1.0);
  Rhegma::Run<2> run(validated(scene));
  run.initialize();
  while (run.state().clock.time < 0.9)
    run.step(1e9, false);
  EXPECT_EQ(summaryOf(run).at("cracks").at(0).at("gas").at("burning_area").get<double>(), 0.0);
  while (run.state().clock.time < 4.0)
    run.step(1e9, false);
  EXPECT_NEAR(summaryOf(run).at("cracks").at(0).at("gas").at("burning_area").get<double>(), 2.0 * 1.5, 1.0);
}

namespace
{

void vents(const std::string& model)
{
  Teuchos::ParameterList scene = burningBlock<2>(true);
  scene.sublist("Combustion").sublist("Slit").set("Gas Model", model);
  scene.sublist("Combustion").sublist("Slit").set("Venting", true);
  Rhegma::Run<2> run(validated(scene));
  run.initialize();
  for (int k = 0; k < 200; ++k)
    run.step(1e9, k == 199);
  const nlohmann::json summary = summaryOf(run);
  EXPECT_GT(summary.at("cracks").at(0).at("gas").at("vented_mass").get<double>(), 0.0);
  EXPECT_NEAR(summary.at("combustion").at("mass_kept").get<double>(), 1.0, 1e-12);
  EXPECT_NEAR(summary.at("cracks").at(0).at("gas").at("energy_kept").get<double>(), 1.0, 1e-10);
}

} // namespace

TEST(Burning, VentsWhereTheCrackOpensAtTheSurface) { vents("Uniform"); }
TEST(Burning, VentsGasThatFlowsThere) { vents("Flow"); }

TEST(Burning, RefusesToVentAClosedCrack)
{
  Teuchos::ParameterList scene = burningBlock<2>(false);
  scene.sublist("Combustion").sublist("Slit").set("Venting", true);
  Rhegma::Run<2> run(validated(scene));
  EXPECT_THROW(run.initialize(), std::invalid_argument);
}

/// Faces that burn very fast use up what lies next to them; then they stop, and no value is negative or not a
/// number.
TEST(Burning, EndsWithTheFuel)
{
  Teuchos::ParameterList scene = burningBlock<2>(false);
  Teuchos::ParameterList& burning = scene.sublist("Combustion").sublist("Slit");
  burning.set("Burn Exponent", 0.0);
  burning.set("Burn Coefficient", 0.5);
  burning.set("Gas Constant", 1e-3);
  Rhegma::Run<2> run(validated(scene));
  run.initialize();
  State<2>& state = run.state();
  while (state.clock.time < 10.0 && state.failure.empty())
    run.step(1e9, false);
  ASSERT_EQ(state.failure, "");
  bool reported = false;
  for (const std::string& warning : state.warnings)
    reported = reported || warning.find("burnt away") != std::string::npos;
  EXPECT_TRUE(reported);
  const HostParticles<2> particles(state);
  for (int p = 0; p < particles.size; ++p)
  {
    EXPECT_GT(particles.mass(p), 0.0);
    EXPECT_TRUE(std::isfinite(particles.velocity(p, 0)));
  }
  const nlohmann::json summary = summaryOf(run);
  EXPECT_NEAR(summary.at("combustion").at("mass_kept").get<double>(), 1.0, 1e-12);
  EXPECT_EQ(summary.at("cracks").at(0).at("gas").at("burning_area").get<double>(), 0.0);
}

} // namespace Test
} // namespace Rhegma
