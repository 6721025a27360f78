// What `mass_matrix` writes, from a run too small to say anything about speed.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace
{

struct Output
{
  std::string text;
  int status;
};

Output massMatrix(const std::string& options)
{
  Output output;
  FILE* pipe = popen((std::string("'") + RHEGMA_MASS_MATRIX + "' " + options + " 2>/dev/null").c_str(), "r");
  EXPECT_NE(pipe, nullptr);
  std::array<char, 4096> buffer;
  for (std::size_t got; (got = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
    output.text.append(buffer.data(), got);
  output.status = pclose(pipe);
  return output;
}

const std::string scene = std::string("'") + RHEGMA_SOURCE_DIR + "/xml_inputs/verification/dcb_h4.xml' ";

TEST(MassMatrixCost, writesEveryMatrixBesideTheLumpedOne)
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
