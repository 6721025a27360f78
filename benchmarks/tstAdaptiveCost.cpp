// What `adaptive` writes, from a run too small to say anything about speed.

#include "Output.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace
{

Output adaptive(const std::string& options)
{
  return outputOf(std::string("'") + RHEGMA_ADAPTIVE + "' " + options + " 2>/dev/null");
}

std::string scene(const std::string& name)
{
  return std::string("'") + RHEGMA_SOURCE_DIR + "/xml_inputs/verification/" + name + "' ";
}

TEST(AdaptiveCost, writesTheUniformRunsNextToTheAdaptiveOne)
{
  const Output output = adaptive(scene("dcb_adaptive.xml") + "--rounds 1 --finer 1 --interval 3e-6 --json");
  ASSERT_EQ(output.status, 0) << output.text;
  const nlohmann::json runs = nlohmann::json::parse(output.text).at("runs");
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[0].at("name"), "adaptive");
  EXPECT_EQ(runs[1].at("name"), "uniform, cells / 2");
  EXPECT_EQ(runs[0].at("of_adaptive").get<double>(), 1.0);
  EXPECT_EQ(runs[1].at("particles").get<int>(), 160 * 32 * 4); // 160 by 32 cells of four
  EXPECT_GT(runs[0].at("particles").get<int>(), 80 * 16 * 4);  // more than the lattice's
  EXPECT_GT(runs[1].at("steps").get<int>(), runs[0].at("steps").get<int>());
  for (const nlohmann::json& run : runs)
    EXPECT_GT(run.at("us_per_step").get<double>(), 0.0);
}

// Both of a pair have the same cells, so what Sub-Cycling saves is steps of particles in large cells.
TEST(AdaptiveCost, writesSmallStepsEverywhereNextToSubsteps)
{
  const Output output = adaptive(scene("dcb_adaptive.xml") + "--rounds 1 --levels 2 --interval 3e-6 --json");
  ASSERT_EQ(output.status, 0) << output.text;
  const nlohmann::json levels = nlohmann::json::parse(output.text).at("levels");
  ASSERT_EQ(levels.size(), 2u);
  for (int level = 1; level <= 2; ++level)
  {
    const nlohmann::json& entry = levels[level - 1];
    EXPECT_EQ(entry.at("maximum_level").get<int>(), level);
    const nlohmann::json& small = entry.at("short_in_small_cells");
    const nlohmann::json& everywhere = entry.at("short_everywhere");
    EXPECT_EQ(small.at("particles"), everywhere.at("particles"));
    const auto steps = small.at("steps").get<double>();
    EXPECT_NEAR(everywhere.at("steps").get<double>(), steps * (1 << level), 1 << level);
    EXPECT_GT(small.at("particle_steps").get<double>(), steps * small.at("particles").get<double>());
    EXPECT_GT(entry.at("times_fewer_particle_steps").get<double>(), 1.0);
    EXPECT_LT(entry.at("times_fewer_particle_steps").get<double>(), 1 << level);
    EXPECT_DOUBLE_EQ(entry.at("times_faster").get<double>(),
                     everywhere.at("seconds_per_simulated_ms").get<double>() /
                         small.at("seconds_per_simulated_ms").get<double>());
  }
}

TEST(AdaptiveCost, refusesWhatItDoesNotKnow)
{
  const std::string good = scene("dcb_adaptive.xml");
  for (const std::string& wrong :
       {std::string(), good + "--rounds ten", good + "--round 3", good + good, good + "--interval -1",
        good + "--levels 0", scene("dcb_h4.xml"), std::string("no_such_file.xml --rounds 1")})
    EXPECT_EQ(WEXITSTATUS(adaptive(wrong).status), 1) << wrong;
}

} // namespace
