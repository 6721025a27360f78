/// Differences of scenes, and parameters that may change when a run continues.

#include "checkpoint/SceneText.hpp"
#include "plan/EffectSchema.hpp"
#include "scene/Scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace Rhegma;

namespace
{

using Lines = std::vector<std::string>;

Lines linesOf(const std::vector<std::string>& overrides, const std::string& scene = "examples/dcb")
{
  const SceneResult result =
      readScene(std::string(RHEGMA_SOURCE_DIR) + "/xml_inputs/" + scene + ".xml", overrides, effectSchema());
  for (const SceneError& error : result.errors)
    ADD_FAILURE() << toString(error);
  return sceneLines(*result.list, effectSchema());
}

} // namespace

TEST(SceneText, LeavesOutWhatMayChange)
{
  const Lines lines = linesOf({});
  EXPECT_EQ(lines,
            linesOf({"Time:Final Time=1", "Time:CFL=0.1", "Time:Maximum Steps=3", "Output:Fields=false",
                     "Output:Checkpoint Interval=0.01", "Damping:Stop When Settled=false",
                     "Damping:Settled Drift=0.5", "Damping:Settled Samples=9"}));
  EXPECT_EQ(hashOfScene(lines), hashOfScene(linesOf({})));
}

TEST(SceneText, HasDefaultsToTheLastDigit)
{
  const Lines lines = linesOf({});
  EXPECT_EQ(std::count(lines.begin(), lines.end(), "Time > PIC Fraction = 0"), 1);
  EXPECT_NE(hashOfScene(lines), hashOfScene(linesOf({"Damping:Bulk Viscosity=1e-300"})));
}

TEST(SceneText, NamesTheFirstDifference)
{
  EXPECT_EQ(differenceOfScenes({"A", "A > x = 1"}, {"A", "A > x = 1"}), "");
  EXPECT_EQ(differenceOfScenes({"A", "A > x = 1"}, {"A", "A > x = 2"}),
            "A > x is \"1\" in the scene and \"2\" in the checkpoint");
  EXPECT_EQ(differenceOfScenes({"A", "B"}, {"A"}), "B is in the scene and not in the checkpoint");
  EXPECT_EQ(differenceOfScenes({"A"}, {"A", "B"}), "B is in the checkpoint and not in the scene");
  EXPECT_EQ(differenceOfScenes({"A", "C"}, {"A", "B", "C"}), "B is in the checkpoint and not in the scene");
  EXPECT_EQ(differenceOfScenes({"A", "B"}, {"B", "A"}),
            "A is at another position in the order of the scene than in the checkpoint");
}

/// A factor multiplies the loads of Final Time; loads that are given do not depend on it.
TEST(SceneText, KeepsFinalTimeOfALoadFactor)
{
  const std::string scene = "verification/dcb_growth_static",
                    given = "Propagation:Load Control=Functions of Time", longer = "Time:Final Time=7";
  const std::string difference = differenceOfScenes(linesOf({longer}, scene), linesOf({}, scene));
  EXPECT_EQ(difference.rfind("Time > Final Time is \"7\" in the scene", 0), 0U) << difference;
  const SceneResult result =
      readScene(std::string(RHEGMA_SOURCE_DIR) + "/xml_inputs/" + scene + ".xml", {}, effectSchema());
  const std::string reason = reasonOfDifference(difference, *result.list, effectSchema());
  EXPECT_NE(reason.find("Load Control = Load Factor"), std::string::npos) << reason;
  EXPECT_EQ(reasonOfDifference("Time > Analysis is", *result.list, effectSchema()), "");
  EXPECT_EQ(differenceOfScenes(linesOf({given, longer}, scene), linesOf({given}, scene)), "");
}
