// What `ranks` writes, from a run too small to say anything about speed.

#include "Output.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace
{

TEST(RanksCost, writesAllRanksNextToOneAndTheirMessages)
{
  if (outputOf("command -v mpirun").status != 0)
    GTEST_SKIP() << "without mpirun";
  // This program runs inside of MPI itself, of which the next must hear nothing.
  const std::string fresh =
      "env $(env | sed -nE 's/^((OMPI|PMIX|PMI|ORTE)_[A-Za-z0-9_]*)=.*/-u \\1/p') OMPI_ALLOW_RUN_AS_ROOT=1 "
      "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMP_NUM_THREADS=1 ";
  const Output output =
      outputOf(fresh + "mpirun --oversubscribe -np 3 '" + RHEGMA_RANKS + "' '" + RHEGMA_SOURCE_DIR +
               "/xml_inputs/verification/dcb_adaptive.xml' --rounds 1 --interval 3e-6 "
               "--json 2>/dev/null");
  ASSERT_EQ(output.status, 0) << output.text;
  const nlohmann::json all = nlohmann::json::parse(output.text);
  EXPECT_EQ(all.at("ranks"), 3);
  ASSERT_EQ(all.at("runs").size(), 2u);
  EXPECT_EQ(all.at("runs")[0].at("steps"), all.at("runs")[1].at("steps"));
  EXPECT_GT(all.at("times_faster").get<double>(), 0.0);
  const nlohmann::json& messages = all.at("messages");
  // The beam is cut twice across, so that the middle part has two neighbours.
  EXPECT_GE(messages.at("receivers").get<double>(), 2.0);
  // At least mass, momentum, force and what strains, each to the owner of a node and back.
  EXPECT_GE(messages.at("sent_per_step").get<double>(), 6.0);
  EXPECT_GT(messages.at("bytes_per_step").get<double>(), 8.0 * messages.at("sent_per_step").get<double>());
  EXPECT_GE(messages.at("reductions_per_step").get<double>(), 2.0);
  double before = 2.0;
  for (const nlohmann::json& entry : all.at("model"))
  {
    const auto fraction = entry.at("work_fraction").get<double>();
    EXPECT_LT(fraction, before) << entry;
    EXPECT_GT(fraction, 0.0);
    before = fraction;
  }
  EXPECT_EQ(all.at("model")[0].at("work_fraction").get<double>(), 1.0);
  EXPECT_EQ(all.at("model").back().at("ranks"), 1000);
}

} // namespace
