#include "SmallState.hpp"
#include "output/CoreRow.hpp"
#include "state/EnergySums.hpp"

#include <nlohmann/json.hpp>

using namespace Rhegma;

namespace
{

std::vector<std::string> names(const HistoryRow& row)
{
  std::vector<std::string> all;
  for (const auto& column : row)
    all.push_back(column.first);
  return all;
}

} // namespace

/// 1 kg at (3, 4) m/s and 2 kg at (-1, 0): 25/2 + 2/2 J and (1, 4) kg m/s.
TEST(CoreRow, SumsKineticEnergyAndMomentum)
{
  State<2> state = smallState<2>(2);
  fill(state.particles.table(fields::mass), {1.0, 2.0});
  fill(state.particles.table(fields::velocity), {3.0, 4.0, -1.0, 0.0});
  measureEnergy(state);
  EXPECT_DOUBLE_EQ(state.energy.kinetic, 13.5);
  EXPECT_DOUBLE_EQ(state.energy.strain, 0.0);
  EXPECT_DOUBLE_EQ(state.sample.momentum[0], 1.0);
  EXPECT_DOUBLE_EQ(state.sample.momentum[1], 4.0);
}

/// Stretch 2 along z: E_zz = 3/2, W = (lambda/2 + mu) E_zz^2 = 3.5 * 9/4 J/m3 in a volume of 1/4 m3.
TEST(CoreRow, SumsStrainEnergyOverUndeformedVolume)
{
  State<3> state = smallState<3>(2);
  fill(state.particles.table(fields::deformation), {1, 0, 0, 0, 1, 0, 0, 0, 2, 1, 0, 0, 0, 1, 0, 0, 0, 1});
  measureEnergy(state);
  EXPECT_DOUBLE_EQ(state.energy.strain, 3.5 * 2.25 * 0.25);
  EXPECT_EQ(state.energy.plastic, 0.0);
}

/// Plane strain, stretch 2 along x: the same energy by its plane components.
TEST(CoreRow, SumsStrainEnergyInPlaneStrain)
{
  State<2> state = smallState<2>(1);
  fill(state.particles.table(fields::deformation), {2, 0, 0, 1, 1});
  measureEnergy(state);
  EXPECT_DOUBLE_EQ(state.energy.strain, 3.5 * 2.25 * 0.25);
}

TEST(CoreRow, HasOnlyColumnsThatTheEffectsGive)
{
  State<2> state = smallState<2>(1);
  coreRow(state, {});
  EXPECT_EQ(names(state.sample.row), (std::vector<std::string>{"kinetic", "strain", "external_work",
                                                               "residual", "momentum_x", "momentum_y"}));
  state.sample.row.clear();
  coreRow(state, {"damped", "contact"});
  EXPECT_EQ(names(state.sample.row),
            (std::vector<std::string>{"kinetic", "strain", "external_work", "damped", "contact", "residual",
                                      "momentum_x", "momentum_y"}));
  State<3> solid = smallState<3>(1);
  coreRow(solid, {"thermal", "heat", "damped", "contact", "fracture", "merged", "combustion"});
  EXPECT_EQ(names(solid.sample.row),
            (std::vector<std::string>{"kinetic", "strain", "thermal", "heat", "external_work", "damped",
                                      "contact", "fracture", "merged", "combustion", "residual", "momentum_x",
                                      "momentum_y", "momentum_z"}));
}

TEST(CoreRow, ComesBeforeTheColumnsOfEffects)
{
  State<2> state = smallState<2>(1);
  state.sample.row.emplace_back("Notch.0.G_J", 1.0);
  coreRow(state, {});
  EXPECT_EQ(state.sample.row.front().first, "kinetic");
  EXPECT_EQ(state.sample.row.back().first, "Notch.0.G_J");
}

/// 3 J/m3 and 5 J/m3 spent in 1/4 m3 each; the energy balance balances what was spent against what was done.
TEST(CoreRow, RecordsPlasticWork)
{
  State<3> state = smallState<3>(2);
  constexpr int size = J2Plastic::historySize<3>;
  state.particles.add({fields::history, size, "", ""});
  std::vector<double> history(2 * size, 0.0);
  history[J2Plastic::dissipationIndex<3>] = 3.0;
  history[size + J2Plastic::dissipationIndex<3>] = 5.0;
  fill(state.particles.table(fields::history), history);
  state.materials.properties[0].law = lawIndex<J2Plastic>;
  state.materials.properties[0].own[J2Number::yield] = 1.0;
  const auto host = Kokkos::create_mirror_view(state.materials.device);
  host(0) = state.materials.properties[0];
  Kokkos::deep_copy(state.materials.device, host);
  state.energy.externalWork = 2.5;
  coreRow(state, {});
  EXPECT_DOUBLE_EQ(state.energy.plastic, 2.0);
  const auto all = names(state.sample.row);
  const auto plastic = std::find(all.begin(), all.end(), "plastic");
  ASSERT_NE(plastic, all.end());
  EXPECT_DOUBLE_EQ(state.sample.row[plastic - all.begin()].second, 2.0);
  const auto residual = std::find(all.begin(), all.end(), "residual");
  EXPECT_DOUBLE_EQ(state.sample.row[residual - all.begin()].second, -0.5);
}

TEST(CoreRow, ReportsTheWholeEnergyBalance)
{
  State<3> state = smallState<3>(1);
  fill(state.particles.table(fields::velocity), {1.0, 2.0, 3.0});
  measureEnergy(state);
  nlohmann::json summary;
  coreReport(state, summary);
  EXPECT_EQ(summary["momentum"], nlohmann::json({1.0, 2.0, 3.0}));
  for (const char* key : {"kinetic", "strain", "thermal", "external_work", "damped", "contact", "fracture",
                          "merged", "combustion", "residual"})
    EXPECT_TRUE(summary["energy"].contains(key)) << key;
  EXPECT_FALSE(summary["energy"].contains("plastic"));
  EXPECT_DOUBLE_EQ(summary["energy"]["kinetic"].get<double>(), 7.0);
}
