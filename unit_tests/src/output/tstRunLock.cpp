/// One run in a folder, and others that only ask.

#include "SmallState.hpp"
#include "output/RunLock.hpp"

#include <chrono>
#include <fcntl.h>
#include <memory>
#include <stdexcept>
#include <sys/file.h>
#include <thread>
#include <unistd.h>

using Rhegma::contents;
using Rhegma::Folder;
using Rhegma::refuseFolderInUse;
using Rhegma::RunLock;

namespace
{

using Clock = std::chrono::steady_clock;

/// Shares the lock of a folder, as a program does that asks whether a run goes on.
class Look
{
public:
  explicit Look(const std::string& path) : file_(open(path.c_str(), O_RDWR | O_CREAT, 0644))
  {
    locked_ = flock(file_, LOCK_SH | LOCK_NB) == 0;
  }
  ~Look() { close(file_); }
  bool locked() const { return locked_; }

private:
  int file_;
  bool locked_;
};

std::string refusal(const std::string& folder)
{
  try
  {
    const RunLock lock(folder);
    return {};
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
}

} // namespace

TEST(RunLock, KeepsAnotherRunOut)
{
  const Folder folder;
  {
    const RunLock lock(folder.path());
    const std::string text = contents(folder.path("run.lock"));
    for (const char* word : {"host: ", "process: ", "started: "})
      EXPECT_NE(text.find(word), std::string::npos) << text;
    const Clock::time_point begin = Clock::now();
    EXPECT_NE(refusal(folder.path()).find("in use by another run"), std::string::npos);
    EXPECT_LT(Clock::now() - begin, std::chrono::seconds(1)) << "it waited as if for a look";
    EXPECT_THROW(refuseFolderInUse(folder.path()), std::invalid_argument);
    EXPECT_EQ(contents(folder.path("run.lock")), text);
  }
  EXPECT_FALSE(std::filesystem::exists(folder.path("run.lock")));
  EXPECT_EQ(refusal(folder.path()), "");
}

/// Two that ask at once do not take each other for a run.
TEST(RunLock, LooksDoNotRefuseEachOther)
{
  const Folder folder;
  const Look look(folder.path("run.lock"));
  ASSERT_TRUE(look.locked());
  EXPECT_NO_THROW(refuseFolderInUse(folder.path()));
}

/// A run that starts while others ask waits for them.
TEST(RunLock, StartsAlthoughOthersLook)
{
  const Folder folder;
  auto look = std::make_unique<Look>(folder.path("run.lock"));
  ASSERT_TRUE(look->locked());
  std::thread end(
      [&look]
      {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        look.reset();
      });
  EXPECT_EQ(refusal(folder.path()), "");
  end.join();
}

TEST(RunLock, ALookMakesNoFile)
{
  const Folder folder;
  refuseFolderInUse(folder.path());
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

namespace
{

const std::string ofAnother = "host: elsewhere\nprocess: 7\nstarted: 2020-01-01 00:00:00 UTC\n";

/// What a user does who starts another run in the folder of one that is going on.
void giveToAnother(const std::string& path)
{
  std::filesystem::remove(path);
  std::ofstream(path) << ofAnother;
}

} // namespace

TEST(RunLock, LeavesTheLockOfAnotherRun)
{
  const Folder folder;
  {
    const RunLock lock(folder.path());
    giveToAnother(folder.path("run.lock"));
  }
  EXPECT_EQ(contents(folder.path("run.lock")), ofAnother);
}

TEST(RunLock, NamesTheRunThatHasTakenTheFolder)
{
  const Folder folder;
  RunLock lock(folder.path());
  EXPECT_FALSE(lock.isDue());
  EXPECT_EQ(lock.loss(), "");
  EXPECT_TRUE(lock.holds());
  giveToAnother(folder.path("run.lock"));
  const std::string loss = lock.loss();
  EXPECT_FALSE(lock.holds());
  for (const std::string& word : {std::string("process 7 on elsewhere since 2020-01-01 00:00:00 UTC"),
                                  "process " + std::to_string(getpid()) + " on ", folder.path()})
    EXPECT_NE(loss.find(word), std::string::npos) << loss;
  EXPECT_EQ(contents(folder.path("run.lock")), ofAnother);
}

/// A run stops where its lock was removed; until then it has the folder, and its files can be written.
TEST(RunLock, TakesAFolderAgainThatNoOtherRunHas)
{
  const Folder folder;
  {
    RunLock lock(folder.path());
    std::filesystem::remove(folder.path("run.lock"));
    EXPECT_NE(lock.loss().find("was removed during the run"), std::string::npos);
    EXPECT_TRUE(lock.holds());
    EXPECT_NE(refusal(folder.path()).find("in use by another run"), std::string::npos);
    EXPECT_EQ(lock.loss(), "");
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

/// Some file systems give a file another number when it is looked up again.
TEST(RunLock, KnowsItsFileByWhatIsInIt)
{
  const Folder folder;
  {
    RunLock lock(folder.path());
    std::filesystem::copy_file(folder.path("run.lock"), folder.path("copy"));
    std::filesystem::rename(folder.path("copy"), folder.path("run.lock"));
    EXPECT_EQ(lock.loss(), "");
    EXPECT_TRUE(lock.holds());
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}
