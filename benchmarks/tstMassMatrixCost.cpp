// What `mass_matrix` writes, from a run too small to say anything about speed.

#include "Output.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace
{

Output massMatrix(const std::string& options)
{
  return outputOf(std::string("'") + RHEGMA_MASS_MATRIX + "' " + options + " 2>/dev/null");
}

const std::string scene = std::string("'") + RHEGMA_SOURCE_DIR + "/xml_inputs/verification/dcb_h4.xml' ";

TEST(MassMatrixCost, writesEveryMatrixNextToTheLumpedOne)
{
  const Output output = massMatrix(scene + "--steps 3 --rounds 2 --warm-up 4 --json");
  ASSERT_EQ(output.status, 0) << output.text;
  const nlohmann::json all = nlohmann::json::parse(output.text);
  std::vector<std::string> names;
  for (const nlohmann::json& entry : all.at("matrices"))
  {
    names.push_back(entry.at("name").get<std::string>());
    EXPECT_GT(entry.at("us_per_step").get<double>(), 0.0);
    EXPECT_EQ(entry.contains("cg_iterations_mean"), names.back() == "Full" || names.back() == "Partial");
  }
  EXPECT_EQ(names, (std::vector<std::string>{"Lumped", "FMPM(2)", "Partial", "Full"}));
  EXPECT_EQ(all.at("matrices").front().at("of_lumped").get<double>(), 1.0);
  EXPECT_EQ(all.at("particles").get<int>(), 40 * 8 * 4); // 40 by 8 cells of four
}

TEST(MassMatrixCost, refusesWhatItDoesNotKnow)
{
  for (const std::string& wrong : {std::string(), scene + "--steps ten", scene + "--step 3", scene + scene,
                                   std::string("no_such_file.xml --steps 1")})
    EXPECT_EQ(WEXITSTATUS(massMatrix(wrong).status), 1) << wrong;
}

} // namespace
