/// Gas of cracks that meet.

#include "packages/propagation/JunctionScenes.hpp"

#include "archive/Archive.hpp"
#include "combustion/Cavity.hpp"
#include "cracks/CrackMemory.hpp"

#include <algorithm>
#include <array>
#include <iostream>
#include <string>

using namespace Rhegma;
using namespace Rhegma::Test;

namespace
{

/// Two cracks in one line with gas in both, which flows out at the edges; that of Roof has twice the
/// pressure.
void cutInTwoWithGas(Teuchos::ParameterList& scene)
{
  cutInTwo(scene);
  for (const char* name : {"Roof", "Wall"})
  {
    Teuchos::ParameterList& burning = scene.sublist("Combustion").sublist(name);
    burning.set("Burn Law", std::string("Vieille"));
    burning.set("Burn Coefficient", 0.0);
    burning.set("Burn Exponent", 1.0);
    burning.set("Gas Constant", 320.0);
    burning.set("Flame Temperature", 2500.0);
    burning.set("Initial Pressure", name[0] == 'R' ? 4e5 : 2e5);
    burning.set("Initial Gap", 1e-5);
    burning.set("Venting", true);
  }
}

/// The same, with gases that can't mix.
void cutInTwoWithOtherGas(Teuchos::ParameterList& scene)
{
  cutInTwoWithGas(scene);
  scene.sublist("Combustion").sublist("Wall").set("Gas Constant", 300.0);
}

/// Gas in the first of both only.
void cutInTwoWithGasInOne(Teuchos::ParameterList& scene)
{
  cutInTwoWithGas(scene);
  scene.sublist("Combustion").remove("Wall");
}

/// The corner with gas in both cracks: that of Wall, below Roof, has four times the pressure.
void cutACornerWithGas(Teuchos::ParameterList& scene)
{
  cutInTwoWithGas(scene);
  for (const char* name : {"Top", "Bottom"})
    scene.sublist("Boundaries").remove(name);
  cutACorner(scene);
  for (const char* name : {"Roof", "Wall"})
  {
    Teuchos::ParameterList& burning = scene.sublist("Combustion").sublist(name);
    burning.set("Initial Pressure", name[0] == 'R' ? 1e5 : 4e5);
    burning.set("Initial Temperature", 2500.0);
    burning.set("Cavity Volume", 5e-7);
    burning.set("Venting", false);
  }
}

nlohmann::json summaryOf(const Rhegma::Run<2>& run)
{
  nlohmann::json summary;
  for (const Effect<2>& effect : run.plan().effects)
    if (effect.report)
      effect.report(run.state(), summary);
  return summary;
}

/// What of the gas of two cracks that met must hold, whatever passes. \return what has come to each [kg]
std::array<double, 2> passedMass(const Rhegma::Run<2>& run)
{
  const nlohmann::json summary = summaryOf(run);
  const auto of = [&](int crack, const char* what)
  { return summary.at("cracks").at(crack).at("gas").at(what).get<double>(); };
  EXPECT_NEAR(summary.at("combustion").at("mass_kept").get<double>(), 1.0, 1e-12);
  for (const int crack : {0, 1})
    EXPECT_NEAR(of(crack, "energy_kept"), 1.0, 1e-12);
  EXPECT_NEAR(of(0, "passed_energy"), -of(1, "passed_energy"), 1e-12 * of(0, "energy"));
  return {of(0, "passed_mass"), of(1, "passed_mass")};
}

long warningsThatGasStays(const State<2>& state)
{
  return std::count_if(state.warnings.begin(), state.warnings.end(),
                       [](const std::string& warning)
                       { return warning.find("no gas flows from one to the other") != std::string::npos; });
}

void runOn(Rhegma::Run<2>& run, double time)
{
  while (run.state().clock.time < time && run.state().failure.empty())
    run.step(1.0, false);
  ASSERT_EQ(run.state().failure, "");
}

} // namespace

/// Where two cracks have met the gas of the higher pressure flows into the other, and none flows out, as it
/// does at the edges of the plate.
TEST(JunctionGas, PassesWhereFrontsMeet)
{
  Piece piece = runWall(cutInTwoWithGas);
  ASSERT_GE(piece.joined, 0.0);
  State<2>& state = piece.run.state();
  runOn(piece.run, piece.joined + 2e-5);
  // Roof begins at the left edge, Wall at the right one; the same after a restart.
  for (const bool again : {false, true})
  {
    if (again)
    {
      Record record;
      Archive saving = Archive::saving(record);
      cracks::storeCracks(state, saving);
      Archive loading = Archive::loading(record);
      cracks::storeCracks(state, loading);
    }
    for (const int crack : {0, 1})
    {
      const std::array<double, 2> out = combustion::surfaceEndAreas(state, crack, {}),
                                  on = combustion::joinedAreas(state, crack);
      EXPECT_GT(out[0], 0.0);
      EXPECT_EQ(out[1], 0.0);
      EXPECT_EQ(on[0], 0.0);
      EXPECT_GT(on[1], 0.0);
    }
  }
  const std::array<double, 2> passed = passedMass(piece.run);
  EXPECT_LT(passed[0], 0.0);
  EXPECT_EQ(passed[0], -passed[1]);
  EXPECT_EQ(warningsThatGasStays(state), 0);
}

/// Nothing flows out of closed cracks. The gas of the one that ends on the other flows into that, and both
/// come to one pressure, but for what it takes to follow the faces, which go on opening.
TEST(JunctionGas, PassesFromACrackToThatOnWhichItEnds)
{
  Piece piece = runWall(cutACornerWithGas);
  ASSERT_GE(piece.joined, 0.0);
  const auto ratio = [&]
  {
    const nlohmann::json summary = summaryOf(piece.run);
    return summary["cracks"][1]["pressure"].get<double>() / summary["cracks"][0]["pressure"].get<double>();
  };
  EXPECT_GT(ratio(), 2.0);
  runOn(piece.run, piece.joined + 5e-6);
  EXPECT_GT(passedMass(piece.run)[0], 0.0);
  for (const double later : {5e-6, 1e-5, 2e-5, 4e-5, 6e-5})
  {
    runOn(piece.run, piece.joined + later);
    std::cout << later << " s later: pressure of Wall over that of Roof " << ratio() << ", come to Roof "
              << passedMass(piece.run)[0] << " kg\n";
  }
  EXPECT_NEAR(ratio(), 1.0, 0.05);
}

/// Gases that differ, or that one crack has only, stay where they are, and a warning says so once.
TEST(JunctionGas, StaysWhereItCannotMix)
{
  for (const auto& cut : {cutInTwoWithOtherGas, cutInTwoWithGasInOne})
  {
    Piece piece = runWall(cut);
    ASSERT_GE(piece.joined, 0.0);
    runOn(piece.run, piece.joined + 2e-5);
    EXPECT_EQ(warningsThatGasStays(piece.run.state()), 1);
    EXPECT_EQ(summaryOf(piece.run)["cracks"][0]["gas"]["passed_mass"].get<double>(), 0.0);
  }
}
