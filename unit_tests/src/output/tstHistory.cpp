#include "SmallState.hpp"
#include "base/OutputError.hpp"
#include "output/History.hpp"

#include <cmath>
#include <csignal>
#include <stdexcept>
#include <sys/resource.h>

using Rhegma::contents;
using Rhegma::Folder;
using Rhegma::History;

TEST(History, WritesAHeaderAndRows)
{
  const Folder folder;
  History history(folder.path("history.csv"));
  history.write(0.5, {{"kinetic", 1.0}, {"strain", -2.5}});
  history.write(1.0, {{"kinetic", 3.0}, {"strain", 0.0}});
  history.close();
  EXPECT_EQ(contents(folder.path("history.csv")), "time,kinetic,strain\n0.5,1,-2.5\n1,3,0\n");
}

TEST(History, KeepsEveryDigit)
{
  const Folder folder;
  const double value = 1.0 / 3.0 * 1.0e-7;
  {
    History history(folder.path("history.csv"));
    history.write(std::nextafter(0.1, 1.0), {{"x", value}});
  }
  std::istringstream text(contents(folder.path("history.csv")));
  std::string header;
  std::getline(text, header);
  double time = 0.0;
  double x = 0.0;
  char comma = ' ';
  text >> time >> comma >> x;
  EXPECT_EQ(time, std::nextafter(0.1, 1.0));
  EXPECT_EQ(x, value);
}

TEST(History, RefusesOtherColumns)
{
  const Folder folder;
  History history(folder.path("history.csv"));
  history.write(0.0, {{"a", 1.0}, {"b", 1.0}});
  EXPECT_THROW(history.write(1.0, {{"a", 1.0}}), std::logic_error);
  EXPECT_THROW(history.write(1.0, {{"a", 1.0}, {"c", 1.0}}), std::logic_error);
  EXPECT_THROW(history.write(1.0, {{"b", 1.0}, {"a", 1.0}}), std::logic_error);
  history.write(1.0, {{"a", 2.0}, {"b", 2.0}});
  history.close();
  EXPECT_EQ(contents(folder.path("history.csv")), "time,a,b\n0,1,1\n1,2,2\n");
  EXPECT_THROW(history.write(2.0, {{"a", 2.0}, {"b", 2.0}}), std::logic_error);
}

TEST(History, RefusesAColumnTwice)
{
  const Folder folder;
  History history(folder.path("history.csv"));
  EXPECT_THROW(history.write(0.0, {{"a", 1.0}, {"a", 1.0}}), std::logic_error);
}

TEST(History, LeavesOutASampleThatComesTwice)
{
  const Folder folder;
  History history(folder.path("history.csv"));
  history.write(0.0, {{"a", 1.0}});
  history.write(0.0, {{"a", 1.0}});
  history.close();
  EXPECT_EQ(contents(folder.path("history.csv")), "time,a\n0,1\n");
}

/// A name with a comma stays one column.
TEST(History, QuotesNames)
{
  const Folder folder;
  History history(folder.path("history.csv"));
  history.write(0.0, {{"a, \"b\".0.G_J", 1.0}});
  history.close();
  EXPECT_EQ(contents(folder.path("history.csv")), "time,\"a, \"\"b\"\".0.G_J\"\n0,1\n");
}

/// The file as another process reads it during the run: empty, or complete rows.
TEST(History, FileHoldsWholeRowsAtAnyTime)
{
  const Folder folder;
  History history(folder.path("history.csv"));
  for (int i = 0; i < 100; ++i)
  {
    history.write(i, {{"a", i / 3.0}});
    const std::string text = contents(folder.path("history.csv"));
    EXPECT_TRUE(text.empty() || text.back() == '\n');
  }
  EXPECT_FALSE(contents(folder.path("history.csv")).empty());
}

TEST(History, SaysThatAFileCannotBeMade)
{
  const Folder folder;
  EXPECT_THROW(History(folder.path("no/such/folder.csv")), std::runtime_error);
}

TEST(History, SaysThatTheDiskIsFull)
{
  if (!std::filesystem::exists("/dev/full"))
    GTEST_SKIP();
  History history("/dev/full");
  history.write(0.0, {{"a", 1.0}});
  EXPECT_THROW(history.close(), std::runtime_error);
}

namespace
{

/// Files may not grow beyond a size, as on a full disk.
class SmallFiles
{
public:
  explicit SmallFiles(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN))
  {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallFiles()
  {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

private:
  void (*handler_)(int);
  rlimit before_{};
};

} // namespace

/// After rows were lost the file is the beginning of the history, as long as it says, without a later row.
TEST(History, IsABeginningAfterRowsWereLost)
{
  const Folder folder;
  const std::string path = folder.path("history.csv");
  History history(path);
  history.write(0.0, {{"a", 1.0}});
  history.flush();
  const Rhegma::HistorySoFar before = history.soFar();
  {
    const SmallFiles limit(before.bytes + 5);
    history.write(1.0, {{"a", 1.0 / 3.0}});
    EXPECT_THROW(history.flush(), Rhegma::OutputError);
  }
  EXPECT_EQ(history.whyLost(), path + " can't be written: File too large");
  EXPECT_THROW(history.write(2.0, {{"a", 2.0}}), Rhegma::OutputError);
  EXPECT_THROW(history.flush(), Rhegma::OutputError);
  EXPECT_EQ(contents(path), "time,a\n0,1\n");
  const Rhegma::HistorySoFar after = history.soFar();
  EXPECT_EQ(after.bytes, before.bytes);
  EXPECT_EQ(after.crc, before.crc);
  EXPECT_EQ(after.lastTime, before.lastTime);
  EXPECT_TRUE(Rhegma::beginsWith(path, after));
  EXPECT_THROW(history.sync(), Rhegma::OutputError);
  EXPECT_NO_THROW(history.syncBeginning(before.bytes));
  EXPECT_THROW(history.syncBeginning(before.bytes + 1), Rhegma::OutputError);
  EXPECT_THROW(history.close(), Rhegma::OutputError);
}
