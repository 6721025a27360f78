// What `heat` writes, from runs too small to say anything about speed.

#include "Output.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace
{

Output heat(const std::string& options)
{
  return outputOf(std::string("'") + RHEGMA_HEAT + "' " + options + " 2>/dev/null");
}

std::string scene(const std::string& name)
{
  return std::string("'") + RHEGMA_SOURCE_DIR + "/xml_inputs/verification/" + name + ".xml' ";
}

std::vector<std::string> namesOf(const nlohmann::json& all)
{
  std::vector<std::string> names;
  for (const nlohmann::json& entry : all.at("runs"))
  {
    names.push_back(entry.at("name").get<std::string>());
    EXPECT_GT(entry.at("us").get<double>(), 0.0);
  }
  EXPECT_EQ(all.at("runs").front().at("ratio").get<double>(), 1.0);
  return names;
}

TEST(HeatCost, writesTheSameMotionWithAndWithoutHeat)
{
  const Output output = heat(scene("thermoelastic_rise") + "--steps 3 --rounds 2 --warm-up 4 --json");
  ASSERT_EQ(output.status, 0) << output.text;
  const nlohmann::json all = nlohmann::json::parse(output.text);
  EXPECT_EQ(namesOf(all), (std::vector<std::string>{"without heat", "with heat"}));
  EXPECT_EQ(all.at("particles").get<int>(), 10 * 10 * 4);
}

TEST(HeatCost, writesHeatAloneByEveryMethod)
{
  const Output output = heat(scene("heat_half_space") + "--steps 3 --rounds 2 --warm-up 4 --json");
  ASSERT_EQ(output.status, 0) << output.text;
  EXPECT_EQ(namesOf(nlohmann::json::parse(output.text)),
            (std::vector<std::string>{"Explicit", "Super Time Stepping", "Implicit"}));
}

TEST(HeatCost, refusesWhatItDoesNotKnow)
{
  for (const std::string& wrong : {std::string(), scene("dcb_h4"), scene("heat_half_space") + "--cell none"})
    EXPECT_EQ(WEXITSTATUS(heat(wrong).status), 1) << wrong;
}

} // namespace
