// What `throughput` writes, from a run too small to say anything about speed.

#include "Output.hpp"

#include <nlohmann/json.hpp>

#include <set>
#include <string>
#include <utility>

namespace
{

Output throughput(const std::string& options)
{
  return outputOf(std::string("'") + RHEGMA_THROUGHPUT + "' --steps 5 --rounds 2 --triad 10000 " + options +
                  " 2>&1");
}

TEST(Throughput, writesBandwidthAndEveryCaseForEachNumberOfThreads)
{
  const Output output = throughput("--particles 2000 --json");
  ASSERT_EQ(output.status, 0) << output.text;
  const nlohmann::json all = nlohmann::json::parse(output.text);

  ASSERT_TRUE(all.at("bandwidth_GBs").contains("1"));
  std::set<std::pair<std::string, int>> wanted;
  for (const auto& [threads, bandwidth] : all.at("bandwidth_GBs").items())
  {
    EXPECT_GT(bandwidth.get<double>(), 0.0);
    wanted.emplace("2d-gimp-crack-elsewhere", std::stoi(threads));
    for (const std::string name : {"2d-linear", "2d-gimp", "3d-linear", "3d-gimp"})
      for (const char* shear : {"", "-shear-at-centres"})
        wanted.emplace(name + shear, std::stoi(threads));
  }
  std::set<std::pair<std::string, int>> found;
  for (const nlohmann::json& entry : all.at("cases"))
  {
    found.emplace(entry.at("name").get<std::string>(), entry.at("threads").get<int>());
    EXPECT_GT(entry.at("ns_per_particle_step").get<double>(), 0.0);
    EXPECT_LE(entry.at("ns_per_particle_step"), entry.at("median_ns_per_particle_step"));
    const bool plane = entry.at("name").get<std::string>().front() == '2';
    EXPECT_EQ(entry.at("bytes_per_particle").get<double>(), plane ? 288.0 : 472.0);
    // 25 by 20 cells of four particles; 9 by 6 by 5 cells of eight.
    EXPECT_EQ(entry.at("particles").get<int>(), plane ? 2000 : 2160);
  }
  EXPECT_EQ(found, wanted);
}

TEST(Throughput, printsTheBoundAndTheRatioOfTheCrackElsewhere)
{
  const Output output = throughput("--particles 2000 --threads 1");
  EXPECT_EQ(output.status, 0);
  EXPECT_NE(output.text.find("bound ns"), std::string::npos) << output.text;
  EXPECT_NE(output.text.find("of 2d-gimp\n"), std::string::npos) << output.text;
}

TEST(Throughput, timesBodiesThatHaveFlown)
{
  const Output output = throughput("--particles 2000 --flow 300 --threads 1 --json");
  ASSERT_EQ(output.status, 0) << output.text;
  for (const nlohmann::json& entry : nlohmann::json::parse(output.text).at("cases"))
    EXPECT_GT(entry.at("ns_per_particle_step").get<double>(), 0.0);
}

TEST(Throughput, refusesWhatItDoesNotKnow)
{
  for (const char* wrong : {"--particle 10", "--particles ten", "--particles 0", "--particles"})
  {
    const Output output = throughput(wrong);
    EXPECT_EQ(WEXITSTATUS(output.status), 1) << wrong;
    EXPECT_EQ(output.text.compare(0, 12, "throughput: "), 0) << output.text;
  }
}

} // namespace
