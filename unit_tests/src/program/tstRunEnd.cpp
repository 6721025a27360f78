/// How a run ended, as summary.json has it.

#include "program/RunEnd.hpp"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>
#include <string>

namespace Rhegma::program
{
namespace Test
{

/// What is written is what is read, by names that differ; the status has the reason of a failure.
TEST(RunEnd, IsReadAsItWasWritten)
{
  const std::string failure = "the run stopped at t = 1 ms";
  std::set<std::string> names;
  for (const RunEnd end :
       {RunEnd::Finished, RunEnd::NotAtRest, RunEnd::CutOff, RunEnd::Stopped, RunEnd::Signalled})
  {
    nlohmann::json summary;
    writeEnd(end, isFinished(end) ? "" : failure, summary);
    EXPECT_EQ(endOf(summary), end);
    EXPECT_TRUE(names.insert(summary["end"].get<std::string>()).second) << summary;
    const std::string status = summary["status"];
    EXPECT_EQ(status.rfind("finished", 0) == 0, isFinished(end)) << summary;
    EXPECT_EQ(status == failure, !isFinished(end)) << summary;
  }
}

/// A missing or unknown end is not taken for one that came to the end of its scene.
TEST(RunEnd, IsNotGuessed)
{
  EXPECT_THROW(endOf(nlohmann::json::object()), std::invalid_argument);
  EXPECT_THROW(endOf({{"end", "well"}, {"status", "finished"}}), std::invalid_argument);
  EXPECT_THROW(endOf({{"end", 3}}), std::invalid_argument);
  EXPECT_THROW(endOf(nullptr), std::invalid_argument);
}

} // namespace Test
} // namespace Rhegma::program
