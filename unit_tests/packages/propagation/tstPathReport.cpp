/// What the path of a growing crack in equilibrium says.

#include "material/StartOfGrowth.hpp"
#include "propagation/HoopStress.hpp"
#include "propagation/PathReport.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace Rhegma;
using namespace Rhegma::propagation;

namespace
{

/// The path of a body of compliance C(a) = c0 + a^n under one load, which grows at G = P^2 C'(a) / 2 = 1 from
/// a = 1 to 3.
std::vector<PathState> pathOf(double c0, double n, int count = 201)
{
  std::vector<PathState> path;
  for (int k = 0; k < count; ++k)
  {
    const double a = 1.0 + 2.0 * k / (count - 1), P = std::sqrt(2.0 / (n * std::pow(a, n - 1.0)));
    path.push_back({double(k), P, P * (c0 + std::pow(a, n)), a - 1.0, 0.0});
  }
  return path;
}

} // namespace

/// d(P C)/da = 0 where (n - 1) / 2 c0 = (n + 1) / 2 a^n: with n = 3 and c0 = 16 at a = 2.
TEST(PathReport, FindsWhereTheLoadFallsAndWhereItsDisplacementFalls)
{
  const PathEvents stiff = eventsOf(pathOf(0.1, 3.0)); // a double cantilever beam
  EXPECT_EQ(stiff.largest, 0);
  EXPECT_EQ(stiff.falls, 0);
  EXPECT_EQ(stiff.again, -1);
  EXPECT_EQ(stiff.snapsBack, -1);
  const std::vector<PathState> path = pathOf(16.0, 3.0);
  const PathEvents soft = eventsOf(path);
  EXPECT_EQ(soft.falls, 0);
  EXPECT_EQ(soft.snapsBack, 0);
  std::size_t least = 0;
  for (std::size_t k = 0; k < path.size(); ++k)
    least = path[k].displacement < path[least].displacement ? k : least;
  EXPECT_NEAR(path[least].area, 1.0, 0.011);
}

TEST(PathReport, FindsWhereTheCrackWouldArrest)
{
  std::vector<PathState> path;
  for (int k = 0; k < 11; ++k) // factors 4 to 0 and up to 9
    path.push_back({double(k), 0.25 * (k - 4) * (k - 4) + 0.1, 1.0 + k, 0.1 * k, 0.0});
  const PathEvents events = eventsOf(path);
  EXPECT_EQ(events.falls, 0);
  EXPECT_EQ(events.again, 8);
  EXPECT_EQ(events.largest, 10);
  EXPECT_EQ(events.snapsBack, -1); // its displacement rises
  nlohmann::json summary;
  reportPathOfEquilibrium(path, true, summary);
  EXPECT_EQ(summary["propagation"]["unstable_from"]["load_factor"], path[0].factor);
  EXPECT_EQ(summary["propagation"]["unstable_to"]["new_area"], path[8].area);
  EXPECT_TRUE(summary["propagation"]["snap_back_from"]["load_factor"].is_null());
  ASSERT_EQ(summary["answers"].size(), 1U);
  EXPECT_NE(summary["answers"][0].get<std::string>().find("unstable"), std::string::npos);
}

/// A Reference names an entry before the run, and before it goes on from a checkpoint with a part of the
/// path.
TEST(PathReport, HasTheSameEntriesWhateverThePath)
{
  for (const bool hasFactor : {false, true})
  {
    const std::vector<PathState> whole = pathOf(16.0, 3.0);
    nlohmann::json known;
    reportPathOfEquilibrium({}, hasFactor, known);
    for (const std::size_t count : {std::size_t(1), whole.size()})
    {
      nlohmann::json summary;
      reportPathOfEquilibrium({whole.begin(), whole.begin() + count}, hasFactor, summary);
      for (const auto& [name, entry] : known["propagation"].items())
      {
        ASSERT_TRUE(summary["propagation"].contains(name)) << name;
        for (const auto& [part, nothing] : entry.items())
          EXPECT_TRUE(!entry.is_object() || summary["propagation"][name].contains(part))
              << name << " " << part << " of " << count;
      }
    }
  }
}

/// Under given loads the sign is that of the change of G over an increment.
TEST(PathReport, OfGivenLoadsFindsWhereGRises)
{
  std::vector<PathState> path;
  for (int k = 0; k < 5; ++k)
    path.push_back({double(k), 0.0, 0.0, 0.1 * (k + 1), k < 3 ? -0.02 : 0.01, k - 1.0, k - 0.25});
  nlohmann::json summary;
  reportPathOfEquilibrium(path, false, summary);
  EXPECT_EQ(summary["propagation"]["unstable_from"]["time"], 3.0);
  EXPECT_EQ(summary["propagation"]["initiation"],
            (nlohmann::json{{"time", -0.25}, {"from", -1.0}, {"to", 0.0}}));
  ASSERT_EQ(summary["answers"].size(), 2U);
  EXPECT_NE(summary["answers"][1].get<std::string>().find("in the load step from 2 s to 3 s"),
            std::string::npos);
  path.resize(3);
  summary.clear();
  reportPathOfEquilibrium(path, false, summary);
  EXPECT_TRUE(summary["propagation"]["unstable_from"]["time"].is_null());
}

/// Motion that follows has an entry from the start, so that a Reference to it is no mistake.
TEST(PathReport, OfMotionThatFollows)
{
  std::vector<PathState> path{{1.0, 0.0, 0.0, 0.1, -0.02, 0.0, 0.9}};
  nlohmann::json summary;
  reportPathOfEquilibrium(path, false, summary, -1.0);
  EXPECT_TRUE(summary["propagation"]["motion_from"]["time"].is_null());
  path.push_back({1.5, 0.0, 0.0, 0.1, 0.3, 1.0, 1.5});
  summary.clear();
  reportPathOfEquilibrium(path, false, summary, 1.5);
  EXPECT_EQ(summary["propagation"]["motion_from"], (nlohmann::json{{"new_area", 0.1}, {"time", 1.5}}));
  EXPECT_EQ(summary["propagation"]["unstable_from"]["time"], 1.5);
  EXPECT_NE(summary["answers"][1].get<std::string>().find("From there on the run is dynamic"),
            std::string::npos);
  summary.clear();
  reportPathOfEquilibrium(path, false, summary);
  EXPECT_FALSE(summary["propagation"].contains("motion_from"));
}

/// In shear alone a crack starts at K_II = sqrt(3)/2 K_Ic, turned by arccos(1/3); without shear at K_Ic.
/// Between them K_I and K_II of the angle satisfy both equations of Erdogan and Sih.
TEST(PathReport, LoadOfTheLargestHoopStress)
{
  EXPECT_EQ(hoopStressLoad(0.0), 1.0);
  EXPECT_NEAR(hoopStressLoad(-std::acos(1.0 / 3.0)), 0.5 * std::sqrt(3.0), 1e-5);
  for (const double ratio : {0.1, 0.25, 0.5, 1.0, 3.0}) // K_II / K_I
  {
    const double t = 2.0 * std::atan((1.0 - std::sqrt(1.0 + 8.0 * ratio * ratio)) / (4.0 * ratio));
    const double hoop = std::pow(std::cos(0.5 * t), 3) - 1.5 * ratio * std::cos(0.5 * t) * std::sin(t);
    EXPECT_NEAR(hoopStressLoad(t), std::sqrt(1.0 + ratio * ratio) / hoop, 1e-9);
  }
}

TEST(PathReport, NamesTheLoadOfFrontsThatTurn)
{
  const std::vector<PathState> path{{0.0, 2.0, 1.0, 0.0, 0.0}};
  nlohmann::json summary = {
      {"cracks",
       {{{"name", "Notch"},
         {"fronts",
          {{{"first_turn", nullptr}, {"hoop_stress_load", nullptr}, {"initiated", nullptr}},
           {{"first_turn", -41.04}, {"hoop_stress_load", 0.8663}, {"initiated", 0.1}},
           {{"first_turn", 70.0}, {"hoop_stress_load", 0.8661}, {"initiated", 0.2}}}}}}}};
  reportPathOfEquilibrium(path, true, summary);
  const auto text = summary["answers"][0].get<std::string>();
  EXPECT_NE(text.find("of a front of crack Notch: it turned by 41 degrees"), std::string::npos) << text;
  EXPECT_NE(text.find("needs about 0.87 of the load, 1.733 times"), std::string::npos) << text;
  summary["cracks"][0]["fronts"][1]["hoop_stress_load"] = 0.998;
  summary["answers"].clear();
  reportPathOfEquilibrium(path, true, summary);
  EXPECT_EQ(summary["answers"][0].get<std::string>().find("turned by"), std::string::npos);
}

/// A front that did not start by G, or started later, with the lowest factor by the largest hoop stress.
TEST(PathReport, NamesAnotherFrontThatStartsFirstByTheLargestHoopStress)
{
  const std::vector<PathState> path{{0.0, 2.0, 1.0, 0.0, 0.0}};
  nlohmann::json summary = {
      {"cracks",
       {{{"name", "Straight"},
         {"fronts", {{{"initiated", 0.1}, {"first_turn", 0.0}, {"hoop_stress_factor", 2.0}}}}},
        {{"name", "Inclined"}, {"fronts", {{{"initiated", nullptr}, {"hoop_stress_factor", 1.8}}}}}}}};
  reportPathOfEquilibrium(path, true, summary);
  auto text = summary["answers"][0].get<std::string>();
  EXPECT_NE(text.find("by the largest hoop stress a front of crack Inclined starts at 1.8 times"),
            std::string::npos)
      << text;
  summary["cracks"][1]["fronts"][0]["hoop_stress_factor"] = 1.995;
  summary["answers"].clear();
  reportPathOfEquilibrium(path, true, summary);
  text = summary["answers"][0].get<std::string>();
  EXPECT_EQ(text.find("hoop stress"), std::string::npos) << text;
}

/// Given loads: the line on the time of the start has the text of the first front.
TEST(PathReport, OfGivenLoadsNamesTheLoadOfAFrontThatTurns)
{
  std::vector<PathState> path{{2.0, 0.0, 0.0, 0.1, 0.0, 1.0, 1.5}};
  nlohmann::json summary = {
      {"cracks",
       {{{"name", "Notch"},
         {"fronts", {{{"first_turn", 41.0}, {"hoop_stress_load", 0.8663}, {"initiated", 2.0}}}}}}}};
  reportPathOfEquilibrium(path, false, summary);
  EXPECT_NE(summary["answers"][0].get<std::string>().find("needs about 0.87 of the load"), std::string::npos);
}

TEST(PathReport, NamesWhatIsThereLaterBeforeTheFirstStep)
{
  nlohmann::json summary;
  reportPathOfEquilibrium({}, true, summary);
  for (const char* name : {"initiation", "largest_load", "unstable_from", "unstable_to", "snap_back_from"})
    EXPECT_TRUE(summary["propagation"][name].contains("load_factor")) << name;
}
