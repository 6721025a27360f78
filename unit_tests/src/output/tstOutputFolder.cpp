#include "SmallState.hpp"
#include "output/OutputFolder.hpp"

#include <stdexcept>

using Rhegma::defaultOutputFolder;
using Rhegma::Folder;
using Rhegma::makeOutputFolder;

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
