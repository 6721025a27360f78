/// What a run says first in its summary and last on the terminal, of made-up summaries.

#include "program/Answer.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace Rhegma::program
{
namespace Test
{

namespace
{

using nlohmann::json;

json finished(int warnings)
{
  json summary = {{"end", "finished"}, {"status", "finished"}, {"time", 4e-3}, {"steps", 120}};
  for (int k = 0; k < warnings; ++k)
    summary["warnings"].push_back("number " + std::to_string(k));
  return summary;
}

std::vector<std::string> answersOf(json summary)
{
  addAnswers(summary);
  return summary["answers"].get<std::vector<std::string>>();
}

} // namespace

/// How many warnings there are, and the first words of three; they are printed in full where they arise.
TEST(Answer, CountsAndNamesWarnings)
{
  using Lines = std::vector<std::string>;
  const std::string end = "the run finished at t = 4 ms after 120 steps",
                    where = "in full above and in summary.json";
  EXPECT_EQ(answersOf(finished(0)), (Lines{end, "no warnings"}));
  EXPECT_EQ(answersOf(finished(1)), (Lines{end, "1 warning (number 0), " + where}));
  EXPECT_EQ(answersOf(finished(3)), (Lines{end, "3 warnings (number 0; number 1; number 2), " + where}));
  EXPECT_EQ(answersOf(finished(5)),
            (Lines{end, "5 warnings (number 0; number 1; number 2; and 2 more), " + where}));
}

/// All that the work went into is named, so that the terms add up; what is rounding is not, nor are ratios.
TEST(Answer, NamesAllTermsOfTheEnergyBalance)
{
  json summary = finished(0);
  summary["energy"] = {{"external_work", 5.0}, {"strain", 2.0},           {"kinetic", 0.5},
                       {"fracture", 0.25},     {"damped", 2.25},          {"heat", 1e-12},
                       {"merged", 0.0},        {"residual", 0.0},         {"contact", nullptr},
                       {"stabilised", 1e-3},   {"largest_fraction", 80.0}};
  EXPECT_EQ(answersOf(summary)[1],
            "energy balance: external work 5 J, strain 2 J, kinetic 500 mJ, fracture 250 mJ, "
            "damped 2.25 J, stabilised 1 mJ; residual 0 J (0 % of the largest of "
            "these)");
}

/// A body that was unloaded has little energy left: the residual is compared with what was supplied.
TEST(Answer, ComparesTheResidualWithTheMostThatWasSupplied)
{
  json summary = finished(0);
  summary["energy"] = {{"external_work", 0.02}, {"strain", 0.01}, {"kinetic", 0.0}, {"residual", 0.01}};
  summary["largest_energy_supplied"] = 1.0;
  EXPECT_NE(answersOf(summary)[1].find("residual 10 mJ (1 % of the 1 J supplied at most)"), std::string::npos)
      << answersOf(summary)[1];
  summary["largest_energy_supplied"] = 0.02;
  EXPECT_NE(answersOf(summary)[1].find("(50 % of the largest of these)"), std::string::npos);
}

/// What the energy at the start is: in equilibrium not that of the state out of balance.
TEST(Answer, NamesTheEnergyAtTheStart)
{
  json summary = finished(0);
  summary["energy"] = {{"external_work", 0.0}, {"strain", 1.0}, {"start", 1.0}, {"residual", 0.0}};
  EXPECT_NE(answersOf(summary)[1].find(", stored at the start 1 J;"), std::string::npos);
  summary["equilibrium"] = {{"last_step_complete", true}};
  EXPECT_NE(answersOf(summary)[1].find(", stored in equilibrium at the start 1 J;"), std::string::npos);
}

/// Of a load step that is not in equilibrium the energies mean nothing.
TEST(Answer, GivesNoEnergyBalanceOfALoadStepWithoutEquilibrium)
{
  json summary = finished(0);
  summary["status"] = "the run stopped at t = 1 s";
  summary["energy"] = {{"external_work", 4e3}, {"strain", 2.0}, {"kinetic", 0.0}, {"residual", -4e3}};
  summary["equilibrium"] = {{"last_step_complete", false}};
  EXPECT_EQ(answersOf(summary)[1],
            "energy balance: not given, as the run stopped within a load step, which has no equilibrium");
  summary["equilibrium"] = {{"last_step_complete", true}};
  EXPECT_NE(answersOf(summary)[1].find("residual -4 kJ"), std::string::npos);
}

/// Under given loads unstable growth releases more than the toughness takes; under a factor it does not.
TEST(Answer, SaysWhatUnstableGrowthLeavesInTheEnergyBalance)
{
  json summary = finished(0);
  summary["energy"] = {{"external_work", 4.0}, {"strain", 2.0}, {"kinetic", 0.0}, {"residual", -2.0}};
  const std::string reason = "unstable growth of cracks under given loads";
  EXPECT_EQ(answersOf(summary)[1].find(reason), std::string::npos);
  summary["propagation"]["unstable_from"] = {{"new_area", 0.1}, {"time", 1.0}, {"load_factor", 0.5}};
  EXPECT_EQ(answersOf(summary)[1].find(reason), std::string::npos);
  summary["propagation"]["unstable_from"] = {{"new_area", nullptr}, {"time", nullptr}};
  EXPECT_EQ(answersOf(summary)[1].find(reason), std::string::npos);
  summary["propagation"]["unstable_from"] = {{"new_area", 0.1}, {"time", 1.0}};
  EXPECT_NE(answersOf(summary)[1].find(reason), std::string::npos);
}

/// Fronts that the cells have stopped come before what effects say; of a front with several nodes, how many
/// of these.
TEST(Answer, NamesFrontsThatTheCellsStopped)
{
  json summary = finished(0);
  summary["answers"] = {"crack A, front 0: ..."};
  json a = {{"name", "A"}}, b = {{"name", "B"}};
  a["fronts"] = {json{{"stop", {{"nodes", 4}, {"of_nodes", 32}}}}, json{{"status", "running"}}};
  b["fronts"] = {json{{"stop", {{"nodes", 1}, {"of_nodes", 1}}}}};
  summary["cracks"] = {a, b};
  const std::vector<std::string> answers = answersOf(summary);
  ASSERT_EQ(answers.size(), 4u);
  EXPECT_EQ(
      answers[1].rfind(
          "numerical stop of 4 of 32 front nodes of crack A, front 0; crack B, front 0 (not arrest)", 0),
      0u)
      << answers[1];
  EXPECT_EQ(answers[2], "crack A, front 0: ...");
}

/// On the terminal the reason of a failure is not said twice.
TEST(Answer, IsPrintedLineByLine)
{
  json summary = finished(1);
  addAnswers(summary);
  std::ostringstream all, failed;
  printAnswers(summary, false, all);
  printAnswers(summary, true, failed);
  const std::string count = "1 warning (number 0), in full above and in summary.json\n";
  EXPECT_EQ(all.str(), "the run finished at t = 4 ms after 120 steps\n" + count);
  EXPECT_EQ(failed.str(), count);
}

} // namespace Test
} // namespace Rhegma::program
