#include "SmallState.hpp"
#include "base/OutputError.hpp"
#include "output/OutputFolder.hpp"

#include <stdexcept>

using Rhegma::defaultOutputFolder;
using Rhegma::Folder;
using Rhegma::makeOutputFolder;

namespace
{

const char* const header = "time,kinetic,strain,thermal,external_work,residual,momentum_x\n";

/// Why a file with a content can't be replaced in a folder; empty: it can.
template <class Refuse>
std::string refusal(const std::string& name, const std::string& content, const Refuse& refuse)
{
  const Folder folder;
  std::ofstream(folder.path(name), std::ios::binary) << content;
  try
  {
    refuse(folder.path(), "scene.xml");
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_EQ(Rhegma::contents(folder.path(name)), content);
    return error.what();
  }
  return {};
}

std::string ofRun(const std::string& name, const std::string& content)
{
  return refusal(name, content, Rhegma::refuseForeignFiles);
}

std::string ofTwice(const std::string& content)
{
  return refusal("twice.json", content, Rhegma::refuseForeignComparison);
}

} // namespace

TEST(OutputFolder, IsNamedAfterTheScene)
{
  EXPECT_EQ(defaultOutputFolder("scenes/dcb.xml"), "scenes/dcb.out");
  EXPECT_EQ(defaultOutputFolder("dcb.fine.xml"), "dcb.fine.out");
  EXPECT_EQ(defaultOutputFolder("scene"), "scene.out");
  EXPECT_EQ(defaultOutputFolder("scene.txt"), "scene.txt.out");
}

TEST(OutputFolder, IsMadeWithThoseAbove)
{
  const Folder folder;
  const std::string path = folder.path("a/b/c");
  EXPECT_EQ(makeOutputFolder(path), path);
  EXPECT_TRUE(std::filesystem::is_directory(path));
  EXPECT_TRUE(std::filesystem::is_empty(path));
}

TEST(OutputFolder, KeepsWhatIsInIt)
{
  const Folder folder;
  std::ofstream(folder.path("summary.json")) << "old";
  EXPECT_EQ(makeOutputFolder(folder.path() + "/"), folder.path() + "/");
  EXPECT_EQ(Rhegma::contents(folder.path("summary.json")), "old");
}

TEST(OutputFolder, SaysWhyItCannotBeUsed)
{
  const Folder folder;
  std::ofstream(folder.path("file")) << "here";
  for (const std::string& path :
       {folder.path("file"), folder.path("file/below"), std::string("/proc/rhegma"), std::string()})
    try
    {
      makeOutputFolder(path);
      ADD_FAILURE() << path;
    }
    catch (const std::invalid_argument& error)
    {
      EXPECT_NE(std::string(error.what()).find(path), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("--output"), std::string::npos) << error.what();
    }
}

/// A table of the user may begin with the time as well.
TEST(OutputFolder, KnowsTheHistoryOfARunByItsColumns)
{
  EXPECT_EQ(ofRun("history.csv", std::string(header) + "0,1,2,3,4,5,6\n"), "");
  EXPECT_EQ(ofRun("history.csv", ""), "");
  for (const char* users : {"time,temperature\n0,293\n", "time\n", "time", "time,kinetic,strain,mine\n",
                            "times of buses\n", "kinetic,strain,external_work,residual\n"})
    EXPECT_NE(ofRun("history.csv", users).find("no run wrote"), std::string::npos) << users;
}

/// What HDF5 does not open may be the user's.
TEST(OutputFolder, KeepsAFileOfHdf5ThatDoesNotOpen)
{
  EXPECT_NE(ofRun("fields.h5", "\x89HDF\r\n\x1a\nhalf a file").find("no run wrote"), std::string::npos);
}

TEST(OutputFolder, KnowsTheComparisonOfTwoRuns)
{
  EXPECT_EQ(ofTwice("{\n  \"answers\": [],\n  \"verdict\": \"\"\n}\n"), "");
  for (const char* users : {"{\"twice\": 2}\n", "answers and a verdict\n"})
    EXPECT_NE(ofTwice(users).find("no run wrote"), std::string::npos) << users;
}

/// Files are written to a name with .part first.
TEST(OutputFolder, KeepsASceneWithTheNameOfAResult)
{
  for (const char* name : {"twice.json", "twice.json.part", "run.lock"})
  {
    const Folder folder;
    std::ofstream(folder.path(name)) << "<ParameterList/>";
    EXPECT_THROW(Rhegma::refuseForeignComparison(folder.path(), folder.path(name)), std::invalid_argument);
  }
  const Folder folder;
  std::ofstream(folder.path("summary.json.part")) << "<ParameterList/>";
  EXPECT_THROW(Rhegma::refuseForeignFiles(folder.path(), folder.path("summary.json.part")),
               std::invalid_argument);
}

TEST(OutputFolder, RenamesToANameThatIsFree)
{
  const Folder folder;
  for (const char* name : {"fields.unread.h5", "fields.unread.2.h5", "fields.unread.3.h5"})
  {
    std::ofstream(folder.path("fields.h5")) << name;
    EXPECT_EQ(Rhegma::setAside(folder.path("fields.h5")), folder.path(name));
    EXPECT_FALSE(std::filesystem::exists(folder.path("fields.h5")));
  }
  for (const char* name : {"fields.unread.h5", "fields.unread.2.h5", "fields.unread.3.h5"})
    EXPECT_EQ(Rhegma::contents(folder.path(name)), name);
  EXPECT_THROW(Rhegma::setAside(folder.path("fields.h5")), Rhegma::OutputError);
}
