/// Files that a run continued from a checkpoint takes from its earlier part.

#include "program/EarlierPart.hpp"

#include "src/output/SmallState.hpp"

namespace Rhegma
{
namespace program
{

namespace
{

void write(const std::string& path, const std::string& text) { std::ofstream(path) << text; }

/// Leaves a history of two rows in a folder.
HistorySoFar leaveHistory(const std::string& folder, double value)
{
  History history(folder + "/history.csv");
  history.write(1.0, {{"energy", value}});
  history.write(2.0, {{"energy", 2.0 * value}});
  history.close();
  return history.soFar();
}

class EarlierParts : public testing::Test
{
protected:
  Folder before, now;
  std::string checkpoint = before.path("checkpoint.h5");
};

} // namespace

TEST_F(EarlierParts, ARunFromItsStartHasNone)
{
  EXPECT_FALSE(EarlierPart().exists());
  EXPECT_EQ(EarlierPart().history().bytes, 0);
}

TEST_F(EarlierParts, BringsHistoryAndFieldsToAnotherFolder)
{
  const HistorySoFar soFar = leaveHistory(before.path(), 3.0);
  write(before.path("fields.h5"), "fields");
  write(now.path("summary.json"), "of an older run");
  const EarlierPart part(checkpoint, now.path(), soFar);
  EXPECT_TRUE(part.exists());
  EXPECT_TRUE(part.warnings().empty());
  // Nothing is changed before it is requested.
  EXPECT_EQ(contents(now.path("summary.json")), "of an older run");
  part.bring();
  EXPECT_EQ(contents(now.path("history.csv")), contents(before.path("history.csv")));
  EXPECT_EQ(contents(now.path("fields.h5")), "fields");
  EXPECT_FALSE(std::filesystem::exists(now.path("summary.json")));
}

TEST_F(EarlierParts, LeavesFilesWhereTheyAre)
{
  const HistorySoFar soFar = leaveHistory(before.path(), 3.0);
  write(before.path("summary.json"), "of the earlier part");
  const std::string history = contents(before.path("history.csv"));
  EarlierPart(checkpoint, before.path(), soFar).bring();
  EXPECT_EQ(contents(before.path("history.csv")), history);
  EXPECT_FALSE(std::filesystem::exists(before.path("summary.json")));
}

TEST_F(EarlierParts, FindsTheHistoryInTheFolderInWhichItGoesOn)
{
  const HistorySoFar soFar = leaveHistory(now.path(), 3.0);
  const EarlierPart part(checkpoint, now.path(), soFar);
  EXPECT_TRUE(part.warnings().empty());
  EXPECT_EQ(part.history().bytes, soFar.bytes);
}

TEST_F(EarlierParts, RefusesAnotherHistory)
{
  const HistorySoFar soFar = leaveHistory(now.path(), 3.0);
  std::filesystem::remove(now.path("history.csv"));
  leaveHistory(before.path(), 4.0);
  EXPECT_THROW(EarlierPart(checkpoint, now.path(), soFar), std::invalid_argument);
}

TEST_F(EarlierParts, WarnsWhereTheHistoryIsGone)
{
  const HistorySoFar soFar = leaveHistory(before.path(), 3.0);
  std::filesystem::remove(before.path("history.csv"));
  const EarlierPart part(checkpoint, now.path(), soFar);
  ASSERT_EQ(part.warnings().size(), 1u);
  EXPECT_NE(part.warnings()[0].find("history.csv"), std::string::npos);
  EXPECT_EQ(part.history().bytes, 0);
}

} // namespace program
} // namespace Rhegma
