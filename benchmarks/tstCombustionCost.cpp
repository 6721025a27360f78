// What `combustion` writes, from runs too small to say anything about speed.

#include "Output.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace
{

Output combustion(const std::string& options)
{
  return outputOf(std::string("'") + RHEGMA_COMBUSTION + "' " + options + " 2>/dev/null");
}

std::string scene(const std::string& name)
{
  return std::string("'") + RHEGMA_SOURCE_DIR + "/xml_inputs/" + name + ".xml' ";
}

TEST(CombustionCost, writesTheSameCrackWithAndWithoutBurning)
{
  const Output output =
      combustion(scene("verification/burning_flow") + "--steps 3 --rounds 2 --warm-up 4 --json");
  ASSERT_EQ(output.status, 0) << output.text;
  const nlohmann::json all = nlohmann::json::parse(output.text);
  ASSERT_EQ(all.at("runs").size(), 5u);
  EXPECT_EQ(all.at("runs").at(0).at("name"), "without combustion");
  EXPECT_EQ(all.at("runs").at(0).at("ratio").get<double>(), 1.0);
  EXPECT_EQ(all.at("runs").at(0).at("ratio_of_processor").get<double>(), 1.0);
  EXPECT_EQ(all.at("runs").at(1).at("name"), "in motion without");
  EXPECT_EQ(all.at("runs").at(2).at("name"), "pressure without gas");
  EXPECT_EQ(all.at("runs").at(3).at("name"), "gas of one pressure");
  EXPECT_EQ(all.at("runs").at(4).at("name"), "gas that flows");
  EXPECT_EQ(all.at("particles").get<int>(), 30 * 30 * 4);
  for (const nlohmann::json& entry : all.at("runs"))
  {
    EXPECT_GT(entry.at("us").get<double>(), 0.0);
    EXPECT_GT(entry.at("ratio_of_processor").get<double>(), 0.0);
  }
}

TEST(CombustionCost, refusesWhatItDoesNotKnow)
{
  for (const std::string& wrong :
       {std::string(), scene("verification/dcb_h4"), scene("verification/burning_flow") + "--steps none"})
    EXPECT_EQ(WEXITSTATUS(combustion(wrong).status), 1) << wrong;
}

} // namespace
