/// Cracks that grow in equilibrium.

#include "Simulation.hpp"
#include "plan/EffectSchema.hpp"
#include "scene/Scene.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <iostream>
#include <map>
#include <random>
#include <string>
#include <vector>

using namespace Rhegma;

namespace
{

/// A run of a verification scene with other parameters, and a row for each of its load steps.
struct GrowthRun
{
  std::vector<std::map<std::string, double>> rows;
  nlohmann::json report;

  /// \param change of what can't be overridden \param interval of rows [s] \param trials solutions before the
  /// run that are not taken
  GrowthRun(const std::string& name, const std::vector<std::string>& more,
            const std::function<void(Teuchos::ParameterList&)>& change = {}, double interval = 1e-9,
            int trials = 0)
  {
    SceneResult scene = readScene(
        std::string(RHEGMA_SOURCE_DIR) + "/xml_inputs/verification/" + name + ".xml", more, effectSchema());
    if (change)
    {
      change(*scene.list);
      validateList(*scene.list, effectSchema(), scene.errors);
    }
    for (const SceneError& error : scene.errors)
      ADD_FAILURE() << toString(error);
    Simulation simulation(Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD)), scene.list);
    simulation.initialize();
    for (int k = 0; k < trials; ++k)
      EXPECT_TRUE(simulation.trySolve());
    simulation.sampleEvery(interval,
                           [&](double time, const std::vector<std::pair<std::string, double>>& row)
                           {
                             rows.emplace_back(row.begin(), row.end());
                             rows.back()["time"] = time;
                           });
    simulation.advance(1.0);
    report = simulation.report();
  }
};

std::string number(double value) { return std::to_string(value); }

} // namespace

/// The work of the loads is what the beam stores and Gc times the new area, wherever the crack lies in its
/// cells and however long its increments are: G by the domain integral is what energy is released. A beam of
/// 4 cells an arm, whose G varies by up to 3 % with the position of the front.
TEST(EquilibriumGrowth, SpendsTheWorkOfTheLoadsOnNewFaces)
{
  const unsigned seed = 7;
  std::mt19937 random(seed);
  std::cout << "seed " << seed << "\n";
  std::uniform_real_distribution<double> any(0.0, 1.0);
  for (int k = 0; k < 3; ++k)
  {
    const double up = k == 0 ? 0.0 : 2.5e-3 * any(random), along = 2.5e-3 * any(random),
                 increment = 0.2 + 0.6 * any(random);
    const GrowthRun run("dcb_growth_static",
                        {"Domain:Cell Size=2.5e-3",
                         "Domain:Lower Corner={" + number(-0.01 - along) + ", " + number(-0.01 - up) + "}",
                         "Domain:Upper Corner={" + number(0.115 - along) + ", " + number(0.035 - up) + "}",
                         "Propagation:Increment=" + number(increment), "Time:Load Steps=12"});
    ASSERT_EQ(run.rows.size(), 12U);
    const auto &first = run.rows.front(), &last = run.rows.back();
    const double grown = 11.0 * increment * 2.5e-3;
    // The crack moves with the arms, which turn and strain: its length is that of the deformed body.
    EXPECT_NEAR(last.at("Notch.0.length") - first.at("Notch.0.length"), grown, 3e-3 * grown);
    EXPECT_NEAR(last.at("fracture"), 100.0 * grown, 1e-3);
    const double residual = (last.at("residual") - first.at("residual")) / last.at("fracture");
    std::cout << "crack " << up / 2.5e-3 << " of a cell up, increments of " << increment
              << ": residual over the energy of new faces " << residual << "\n";
    EXPECT_NEAR(residual, 0.0, 0.03);
    for (const auto& row : run.rows)
      EXPECT_NEAR(row.at("Notch.0.G_J"), 100.0, 0.5);
    EXPECT_EQ(run.report["propagation"]["unstable_from"]["load_factor"], first.at("load_factor"));
    EXPECT_TRUE(run.report["propagation"]["snap_back_from"]["load_factor"].is_null());
  }
}

/// A forecast solves on trial before the run, which is the same after it, to what the factor is found to.
TEST(EquilibriumGrowth, AfterTrialSolutionsIsTheSame)
{
  const std::vector<std::string> beam{"Domain:Cell Size=2.5e-3", "Time:Load Steps=3"};
  const GrowthRun alone("dcb_growth_static", beam), tried("dcb_growth_static", beam, {}, 1e-9, 3);
  ASSERT_EQ(alone.rows.size(), tried.rows.size());
  for (std::size_t k = 0; k < alone.rows.size(); ++k)
  {
    const double factor = alone.rows[k].at("load_factor");
    EXPECT_NEAR(tried.rows[k].at("load_factor"), factor, 1e-5 * factor);
    EXPECT_NEAR(tried.rows[k].at("strain"), alone.rows[k].at("strain"), 2e-5 * alone.rows[k].at("strain"));
  }
}

/// The same beam held at its arms, which the factor moves, and which move in time: the crack is as long at
/// the same motion, to an increment.
TEST(EquilibriumGrowth, UnderMotionsInTimeIsThatOfTheFactor)
{
  const double increment = 0.5, cell = 2.5e-3;
  const std::vector<std::string> both{"Domain:Cell Size=2.5e-3",
                                      "Propagation:Increment=" + number(increment)};
  std::vector<std::string> byFactor = both, byTime = both;
  byFactor.insert(byFactor.end(), {"Time:Load Steps=18", "Propagation:Load Control=Load Factor"});
  byTime.insert(byTime.end(), {"Time:Load Steps=8"});
  const GrowthRun factor("dcb_grips_static", byFactor), time("dcb_grips_static", byTime);
  EXPECT_TRUE(factor.report["propagation"]["unstable_from"]["load_factor"].is_null());
  // The supports move in proportion to time, by 1 at its end, as they do with the factor. The factor is found
  // to 1e-5. The arms turn by 1e-2, by whose square G differs from that of a linear body.
  EXPECT_NEAR(time.report["propagation"]["initiation"]["time"].get<double>(),
              factor.report["propagation"]["initiation"]["load_factor"].get<double>(), 1e-3);
  int compared = 0;
  for (const auto& row : time.rows)
    for (std::size_t k = 1; k < factor.rows.size(); ++k)
    {
      const auto &before = factor.rows[k - 1], &after = factor.rows[k];
      EXPECT_GT(after.at("load_factor"), before.at("load_factor"));
      const double t = row.at("time"), from = before.at("load_factor"), to = after.at("load_factor");
      if (t < from || t > to)
        continue;
      const double length = before.at("Notch.0.length") + (t - from) / (to - from) * increment * cell;
      EXPECT_GE(row.at("Notch.0.length"), length - 0.1 * increment * cell) << "t = " << t;
      EXPECT_LE(row.at("Notch.0.length"), length + 1.1 * increment * cell) << "t = " << t;
      EXPECT_LE(row.at("Notch.0.G_J"), 100.1);
      ++compared;
    }
  EXPECT_GE(compared, 3);
}

/// A crack in the middle of a plate under tension: both fronts advance, as they are alike, and the load falls
/// as the root of its length: K = s sqrt(pi a sec(pi a / W)) (Feddersen, good to 0.3 % here).
TEST(EquilibriumGrowth, OfTwoFrontsAlikeIsOfBoth)
{
  const GrowthRun run("plate_growth_static", {});
  const auto &first = run.rows.front(), &last = run.rows.back();
  const double a = 0.5 * first.at("Slit.0.length"), b = 0.5 * last.at("Slit.0.length"), width = 0.048;
  const auto shape = [&](double half) { return half / std::cos(std::acos(-1.0) * half / width); };
  EXPECT_GT(b, 1.3 * a);
  EXPECT_NEAR(last.at("Slit.0.x") + last.at("Slit.1.x"), first.at("Slit.0.x") + first.at("Slit.1.x"), 1e-5);
  EXPECT_NEAR(last.at("load_factor") / first.at("load_factor"), std::sqrt(shape(a) / shape(b)), 0.01);
  EXPECT_EQ(run.report["propagation"]["unstable_from"]["load_factor"], first.at("load_factor"));
}

/// A pressure on the faces of a crack loads it as the same tension on the plate: the difference of both is
/// a plate under tension whose crack is held closed, without any K. From the first increment on.
TEST(EquilibriumGrowth, StartsUnderPressureAsUnderTension)
{
  const std::vector<std::string> few{"Time:Load Steps=3"};
  const GrowthRun tension("plate_growth_static", few);
  const GrowthRun pressure(
      "plate_growth_static", few,
      [](Teuchos::ParameterList& scene)
      {
        scene.remove("Boundaries");
        scene.sublist("Face Pressure").sublist("Slit").set<std::string>("Pressure", "1e6");
      });
  ASSERT_EQ(pressure.rows.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double expected = tension.rows[k].at("load_factor");
    EXPECT_NEAR(pressure.rows[k].at("load_factor"), expected,
                0.015 * expected); // G of pressure is good to 2 %
    EXPECT_NEAR(pressure.rows[k].at("Slit.0.G_J"), 100.0, 0.5);
  }
}

/// Loads that are there from time 0 on grow from zero in the first step, and later steps add nothing: their
/// work is what the beam stores.
TEST(EquilibriumWork, OfConstantLoadsIsStored)
{
  const GrowthRun run("dcb_static", {"Time:Analysis=Quasi-Static", "Time:Load Steps=4", "Time:Final Time=1"},
                      {}, 0.25);
  ASSERT_EQ(run.rows.size(), 4U);
  for (const auto& row : run.rows)
  {
    EXPECT_GT(row.at("external_work"), 0.0);
    EXPECT_NEAR(row.at("strain") + row.at("stabilised"), row.at("external_work"),
                0.01 * row.at("external_work"));
  }
}
