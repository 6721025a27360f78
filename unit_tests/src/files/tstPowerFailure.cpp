/// What is on the disk when a file is said to be written. A power failure can't be made here; what the
/// program asks of the system before it renames is recorded instead.

#include "base/OutputError.hpp"
#include "files/TextFile.hpp"
#include "output/Manifest.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <sys/syscall.h>
#include <unistd.h>
#include <vector>

namespace
{

std::vector<std::string> synced; ///< names of what was synchronised, in this order
std::string pathOfFailure;       ///< what can't be synchronised

std::string pathOf(int file)
{
  std::error_code none;
  return std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(file), none).string();
}

} // namespace

/// In the place of that of the system.
extern "C" int fsync(int file)
{
  synced.push_back(pathOf(file));
  if (synced.back() == pathOfFailure)
  {
    errno = EIO;
    return -1;
  }
  return static_cast<int>(syscall(SYS_fsync, file));
}

namespace Rhegma
{

namespace
{

using Paths = std::vector<std::string>;

class PowerFailure : public testing::Test
{
protected:
  PowerFailure()
  {
    std::string pattern = (std::filesystem::temp_directory_path() / "rhegma-test-XXXXXX").string();
    folder_ = std::filesystem::canonical(mkdtemp(pattern.data())).string();
    synced.clear();
  }
  ~PowerFailure() override
  {
    pathOfFailure.clear();
    std::filesystem::remove_all(folder_);
  }

  std::string path(const std::string& name) const { return folder_ + "/" + name; }
  void put(const std::string& name, const std::string& text) const { std::ofstream(path(name)) << text; }
  std::string contents(const std::string& name) const
  {
    std::ostringstream text;
    text << std::ifstream(path(name)).rdbuf();
    return text.str();
  }
  std::vector<std::string> names() const
  {
    std::vector<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(folder_))
      found.push_back(entry.path().filename().string());
    std::sort(found.begin(), found.end());
    return found;
  }

  std::string folder_;
};

} // namespace

TEST_F(PowerFailure, AReplacedFileIsOnTheDiskBeforeItsName)
{
  put("a.json", "old");
  replaceFile(path("a.json"), "new");
  EXPECT_EQ(contents("a.json"), "new");
  EXPECT_EQ(synced, (Paths{path("a.json.part"), folder_}));
}

TEST_F(PowerFailure, AFileThatIsReplacedOftenDoesNotWait)
{
  replaceFileUnsynced(path("a.json"), "new");
  EXPECT_EQ(contents("a.json"), "new");
  EXPECT_EQ(synced, Paths{});
}

TEST_F(PowerFailure, AFileThatIsNotOnTheDiskReplacesNone)
{
  put("a.json", "old");
  pathOfFailure = path("a.json.part");
  try
  {
    replaceFile(path("a.json"), "new");
    ADD_FAILURE() << "no error";
  }
  catch (const OutputError& error)
  {
    EXPECT_EQ(error.what(), path("a.json") + " can't be written: Input/output error");
  }
  EXPECT_EQ(contents("a.json"), "old");
  EXPECT_EQ(names(), std::vector<std::string>{"a.json"});
}

/// What a short text lacks is known only when its buffer is written.
TEST_F(PowerFailure, AFullDiskReplacesNoFile)
{
  if (!std::filesystem::exists("/dev/full"))
    GTEST_SKIP();
  put("a.json", "old");
  for (const auto& replace : {replaceFile, replaceFileUnsynced})
  {
    std::filesystem::create_symlink("/dev/full", path("a.json.part"));
    EXPECT_THROW(replace(path("a.json"), "new"), OutputError);
    EXPECT_EQ(contents("a.json"), "old");
    EXPECT_EQ(names(), std::vector<std::string>{"a.json"});
  }
}

/// Two processes that replace a file do not rename the unfinished one of each other.
TEST_F(PowerFailure, ASharedFileHasATemporaryNameOfItsOwn)
{
  put("rates.json.part", "of another process");
  replaceSharedFile(path("rates.json"), "mine");
  EXPECT_EQ(contents("rates.json"), "mine");
  EXPECT_EQ(contents("rates.json.part"), "of another process");
  EXPECT_EQ(names().size(), 2U);
}

/// During a run the manifest does not wait for the disk; at its end it comes after all that it lists.
TEST_F(PowerFailure, TheLastManifestListsWhatIsOnTheDisk)
{
  for (const char* name : {"scene.xml", "history.csv", "fields.h5", "fields.xdmf", "summary.json"})
    put(name, "12345");
  Manifest manifest(folder_, path("scene.xml"));
  manifest.write({3, 77, 0.5});
  EXPECT_EQ(synced, Paths{});
  manifest.write({3, 77, 0.5}, true);
  ASSERT_EQ(synced.size(), 6U);
  EXPECT_EQ(synced[4], path("manifest.json.part"));
  EXPECT_EQ(synced[5], folder_);
  std::sort(synced.begin(), synced.begin() + 4);
  EXPECT_EQ(Paths(synced.begin(), synced.begin() + 4),
            (Paths{path("fields.h5"), path("fields.xdmf"), path("history.csv"), path("summary.json")}));
}

/// The rows that the run has written count, not the file as it is found at the end.
TEST_F(PowerFailure, TheManifestHasTheHistoryThatWasWritten)
{
  for (const char* name : {"scene.xml", "history.csv"})
    put(name, "12345");
  Manifest(folder_, path("scene.xml")).write({3, 77, 0.5}, true);
  const nlohmann::json history =
      nlohmann::json::parse(contents("manifest.json")).at("files").at("history.csv");
  EXPECT_EQ(history, (nlohmann::json{{"bytes", 3}, {"crc32", 77}}));
}

} // namespace Rhegma
