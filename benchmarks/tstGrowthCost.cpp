// What `growth` writes, from runs too small to say anything about speed.

#include "Output.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace
{

Output growth(const std::string& options)
{
  return outputOf(std::string("'") + RHEGMA_GROWTH + "' " + options + " 2>/dev/null");
}

std::string scene(const std::string& name)
{
  return std::string("'") + RHEGMA_SOURCE_DIR + "/xml_inputs/" + name + ".xml' ";
}

TEST(GrowthCost, writesTheSameCrackHeldAndRunning)
{
  const Output output =
      growth(scene("examples/strip_running") + "--cell 0.00125 --steps 20 --rounds 2 --warm-up 10 --json");
  ASSERT_EQ(output.status, 0) << output.text;
  const nlohmann::json all = nlohmann::json::parse(output.text);
  ASSERT_EQ(all.at("runs").size(), 3u);
  EXPECT_EQ(all.at("runs").at(0).at("name"), "cracks held");
  EXPECT_EQ(all.at("runs").at(0).at("ratio").get<double>(), 1.0);
  EXPECT_EQ(all.at("runs").at(0).at("ratio_of_processor").get<double>(), 1.0);
  EXPECT_EQ(all.at("runs").at(1).at("name"), "fronts driven and held");
  EXPECT_EQ(all.at("runs").at(2).at("name"), "cracks that run");
  EXPECT_EQ(all.at("particles").get<int>(), 96 * 16 * 4);
  EXPECT_GT(all.at("increments").get<long>(), 0);
  for (const nlohmann::json& entry : all.at("runs"))
  {
    EXPECT_GT(entry.at("us").get<double>(), 0.0);
    EXPECT_GT(entry.at("ratio_of_processor").get<double>(), 0.0);
  }
}

TEST(GrowthCost, refusesWhatItDoesNotKnow)
{
  for (const std::string& wrong :
       {std::string(), scene("verification/dcb_h4"), scene("examples/strip_running") + "--steps none"})
    EXPECT_EQ(WEXITSTATUS(growth(wrong).status), 1) << wrong;
}

} // namespace
