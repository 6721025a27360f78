/// What the history has of a front, of one node and of several.

#include "energy_release/FrontSample.hpp"
#include "energy_release/HeldFronts.hpp"
#include "energy_release/LargestRelease.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

using namespace Rhegma;
using namespace Rhegma::energy_release;

namespace
{

/// A straight front in 3D of three nodes, 1 and 3 mm apart.
CrackFront<3> straightFront()
{
  CrackFront<3> front;
  const double at[] = {0.0, 1e-3, 4e-3}, tributary[] = {0.5e-3, 2e-3, 1.5e-3};
  for (int k = 0; k < 3; ++k)
  {
    FrontNode<3> node;
    node.name = k;
    node.facet = k < 2 ? k : -1;
    node.position = {0.0, at[k], 0.0};
    node.tributaryLength = tributary[k];
    front.nodes.push_back(node);
  }
  return front;
}

double valueOf(const HistoryRow& row, const std::string& name)
{
  for (const auto& [column, value] : row)
    if (column == name)
      return value;
  ADD_FAILURE() << "no column " << name;
  return 0.0;
}

} // namespace

/// One node: its values, without extremes.
TEST(FrontSample, HasTheValuesOfOneNode)
{
  FrontSample<2> sample(CrackFront<2>(), 0.0);
  sample.J = {12.5};
  sample.modeI = {3e6};
  HistoryRow row;
  sample.addTo(row, "Notch.0", {});
  std::vector<std::string> names;
  for (const auto& column : row)
    names.push_back(column.first);
  EXPECT_EQ(names, (std::vector<std::string>{"Notch.0.G_J", "Notch.0.K_I", "Notch.0.K_II", "Notch.0.length",
                                             "Notch.0.speed", "Notch.0.x", "Notch.0.y"}));
  EXPECT_EQ(valueOf(row, "Notch.0.G_J"), 12.5);
  EXPECT_EQ(valueOf(row, "Notch.0.K_I"), 3e6);
}

/// Of each front the largest of all samples, with its time; those without a number do not count.
TEST(LargestRelease, IsThatOfEachFront)
{
  const auto sample = [](int number, double release)
  {
    CrackFront<2> front;
    front.crack = 1;
    front.number = number;
    FrontSample<2> made(front, 0.0);
    made.J = {release};
    return made;
  };
  LargestRelease largest;
  EXPECT_TRUE(std::isnan(largest.of(1, 0).release));
  largest.add<2>({sample(0, 3.0), sample(1, FrontSample<2>::notYet)}, 0.1);
  largest.add<2>({sample(0, 7.0), sample(1, -2.0)}, 0.2);
  largest.add<2>({sample(0, FrontSample<2>::notYet), sample(1, -4.0)}, 0.3);
  largest.add<2>({sample(0, 5.0)}, 0.4);
  EXPECT_EQ(largest.of(1, 0).release, 7.0);
  EXPECT_EQ(largest.of(1, 0).time, 0.2);
  EXPECT_EQ(largest.of(1, 1).release, -2.0);
  EXPECT_EQ(largest.of(1, 1).time, 0.2);
  EXPECT_TRUE(std::isnan(largest.of(0, 0).release));
}

/// In 3D the mean along the front counts.
TEST(LargestRelease, IsOfTheMeanAlongAFront)
{
  FrontSample<3> sample(straightFront(), 0.0);
  sample.J = {10.0, 20.0, 40.0};
  LargestRelease largest;
  largest.add<3>({sample}, 0.5);
  EXPECT_NEAR(largest.of(sample.front.crack, sample.front.number).release, meanAlong(sample.front, sample.J),
              1e-12);
}

/// Several: their mean by length of front, which is that of the lines between them, and extremes.
TEST(FrontSample, HasMeanAndExtremesAlongAFront)
{
  FrontSample<3> sample(straightFront(), 0.0);
  sample.J = {10.0, 20.0, 40.0};
  HistoryRow row;
  sample.addTo(row, "Disk.0", {});
  EXPECT_NEAR(valueOf(row, "Disk.0.G_J"), (15.0 * 1.0 + 30.0 * 3.0) / 4.0, 1e-12);
  EXPECT_EQ(valueOf(row, "Disk.0.G_J_min"), 10.0);
  EXPECT_EQ(valueOf(row, "Disk.0.G_J_max"), 40.0);
  EXPECT_EQ(valueOf(row, "Disk.0.K_III_max"), 0.0);
}

/// A front in 3D that has ended has no nodes left, and nothing drives it.
TEST(FrontSample, IsZeroWhereNoNodeIsLeft)
{
  CrackFront<3> front;
  front.ended = true;
  HistoryRow row;
  FrontSample<3>(front, 0.0).addTo(row, "Disk.0", {});
  for (const char* name : {"Disk.0.G_J", "Disk.0.G_J_min", "Disk.0.G_J_max", "Disk.0.speed"})
    EXPECT_EQ(valueOf(row, name), 0.0) << name;
}

/// Nodes without a value are left out of mean and extremes; without any the front has none.
TEST(FrontSample, LeavesOutNodesWithoutAValue)
{
  FrontSample<3> sample(straightFront(), 0.0);
  sample.J = {10.0, 20.0, FrontSample<3>::notYet};
  HistoryRow row;
  sample.addTo(row, "Disk.0", {});
  EXPECT_NEAR(valueOf(row, "Disk.0.G_J"), (0.5 * 10.0 + 2.0 * 20.0) / 2.5, 1e-12);
  EXPECT_EQ(valueOf(row, "Disk.0.G_J_min"), 10.0);
  EXPECT_EQ(valueOf(row, "Disk.0.G_J_max"), 20.0);
  HistoryRow none;
  FrontSample<3>(straightFront(), FrontSample<3>::notYet).addTo(none, "Disk.0", {});
  EXPECT_TRUE(std::isnan(valueOf(none, "Disk.0.G_J")));
  EXPECT_TRUE(std::isnan(valueOf(none, "Disk.0.G_J_max")));
}

namespace
{

/// The answers of held fronts of a crack with these values of G; none that is negative.
std::vector<std::string> answersOf(const std::vector<double>& release, bool firstHasGrown = false,
                                   double modeI = 2.5e6)
{
  CrackSet<2> set;
  set.cracks.push_back({"Notch"});
  std::vector<FrontSample<2>> samples;
  nlohmann::json summary;
  summary["answers"] = nlohmann::json::array();
  for (const double G : release)
  {
    CrackFront<2> front;
    front.number = static_cast<int>(set.fronts.size());
    front.grown = firstHasGrown && set.fronts.empty();
    set.fronts.push_back(front);
    samples.emplace_back(front, 0.0);
    samples.back().J = {G};
    samples.back().modeI = {modeI};
    samples.back().modeII = {-300.0};
    samples.back().report({}, summary["cracks"][0]["fronts"][front.number]);
  }
  addAnswersOfHeldFronts(set, samples, 4e-3, summary);
  return summary["answers"].get<std::vector<std::string>>();
}

} // namespace

/// A held front has a line with G, K and the time; one that has grown or whose G is not known has none.
TEST(HeldFronts, SayWhatTheyHave)
{
  const std::string values = " J/m2, K_I = 2.5 MPa m^0.5, K_II = -300 Pa m^0.5 at t = 4 ms";
  EXPECT_EQ(answersOf({12.5, 3.0}), (std::vector<std::string>{"crack Notch, front 0: G = 12.5" + values,
                                                              "crack Notch, front 1: G = 3" + values}));
  EXPECT_EQ(answersOf({12.5, 3.0}, true), (std::vector<std::string>{"crack Notch, front 1: G = 3" + values}));
  EXPECT_TRUE(answersOf({FrontSample<2>::notYet}).empty());
  const std::vector<std::string> many = answersOf({1.0, 6.0, 2.0, 5.0, 4.0, 3.0});
  ASSERT_EQ(many.size(), 5u);
  EXPECT_EQ(many[0], "crack Notch, front 1: G = 6" + values);
  EXPECT_EQ(many[3], "crack Notch, front 5: G = 3" + values);
  EXPECT_EQ(many[4], "these are the 4 fronts with the largest G of 6; summary.json has all");
}

/// Of a closed crack the part of K_II would advance it: 1e-4 / (1 + 1e-4) here, half with as much K_I. Faces
/// that give way a little where they touch are not mentioned.
TEST(HeldFronts, SayWhatAClosedCrackHas)
{
  const std::string closed = "; the crack is closed (K_I < 0), so about ",
                    advance = " J/m2 of G would advance it";
  const auto endOf = [](const std::string& text, const std::string& end)
  { return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0; };
  EXPECT_TRUE(endOf(answersOf({20.0}, false, -3e4).at(0), closed + "0.002" + advance));
  EXPECT_TRUE(endOf(answersOf({20.0}, false, -300.0).at(0), closed + "10" + advance));
  EXPECT_TRUE(endOf(answersOf({20.0}, false, -10.0).at(0), "at t = 4 ms"));
}

/// In 3D a value is a mean along the front, which comes with its range.
TEST(HeldFronts, SayTheRangeAlongAFront)
{
  CrackSet<3> set;
  set.cracks.push_back({"Disk"});
  set.fronts.push_back(straightFront());
  std::vector<FrontSample<3>> samples;
  samples.emplace_back(set.fronts[0], 0.0);
  samples[0].J = {10.0, 20.0, 40.0};
  nlohmann::json summary;
  samples[0].report({}, summary["cracks"][0]["fronts"][0]);
  addAnswersOfHeldFronts(set, samples, 1e-6, summary);
  const std::string line = summary["answers"][0];
  EXPECT_EQ(line.rfind("crack Disk, front 0: G = 26.25 J/m2 (10 J/m2 to 40 J/m2 along the front), K_I = ", 0),
            0u)
      << line;
}
