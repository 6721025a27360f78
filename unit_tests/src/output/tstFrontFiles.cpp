/// fronts.h5 and fronts.csv: samples of growing fronts, and files that a run continues.

#include "Hdf5Reader.hpp"
#include "SmallState.hpp"
#include "archive/Archive.hpp"
#include "base/OutputError.hpp"
#include "output/FrontFiles.hpp"

#include <cmath>
#include <limits>

using namespace Rhegma;

namespace
{

using Numbers = std::vector<double>;

/// A front of so many nodes whose values are its own in each column.
FrontValues front(const std::string& crack, int nodes, double start)
{
  FrontValues values;
  values.crack = crack;
  for (int k = 0; k < nodes; ++k)
  {
    const double at = start + k;
    values.line.push_back(0);
    values.arc.push_back(0.5 * k);
    values.position.push_back({at, at + 0.1, at + 0.2});
    values.release.push_back(at + 0.3);
    values.modeI.push_back(at + 0.4);
    values.modeII.push_back(at + 0.5);
    values.modeIII.push_back(at + 0.6);
    values.speed.push_back(at + 0.7);
  }
  return values;
}

bool exists(const std::string& path) { return std::filesystem::exists(path); }

} // namespace

TEST(FrontFiles, HoldSamplesOfAGrowingFront)
{
  const Folder folder;
  FrontFiles files(folder.path());
  files.write(0.5, {front("Notch", 2, 1.0)});
  files.write(0.75, {front("Notch", 3, 10.0)});
  const Hdf5Reader file(folder.path("fronts.h5"));
  EXPECT_EQ(file.attribute("/t00000", "time"), 0.5);
  EXPECT_EQ(file.attribute("/t00001", "time"), 0.75);
  EXPECT_EQ(file.numbers("/t00000/Notch.0/s"), (Numbers{0.0, 0.5}));
  EXPECT_EQ(file.numbers("/t00001/Notch.0/s"), (Numbers{0.0, 0.5, 1.0}));
  EXPECT_EQ(file.extents("/t00001/Notch.0/position"), (std::vector<std::size_t>{3, 3}));
  EXPECT_EQ(file.numbers("/t00001/Notch.0/position")[5], 11.2);
  const char* names[] = {"G", "K_I", "K_II", "K_III", "speed"};
  for (int q = 0; q < 5; ++q)
    EXPECT_DOUBLE_EQ(file.numbers(std::string("/t00001/Notch.0/") + names[q])[2], 12.0 + 0.1 * (q + 3)) << q;
  EXPECT_EQ(file.numbers("/t00001/Notch.0/line"), (Numbers{0, 0, 0}));
}

TEST(FrontFiles, HaveARowANodeAndSample)
{
  const Folder folder;
  FrontFiles files(folder.path());
  FrontValues odd = front("A, \"b\"", 1, 0.0);
  odd.number = 3;
  odd.release[0] = std::numeric_limits<double>::quiet_NaN();
  files.write(0.5, {front("Notch", 1, 1.0), odd});
  EXPECT_EQ(
      contents(folder.path("fronts.csv")),
      "time,crack,front,node,s,x,y,z,G,K_I,K_II,K_III,speed\n"
      "0.5,Notch,0,0,0,1,1.1000000000000001,1.2,1.3,1.3999999999999999,1.5,1.6000000000000001,1.7\n"
      "0.5,\"A, \"\"b\"\"\",3,0,0,0,0.10000000000000001,0.20000000000000001,nan,0.40000000000000002,0.5,"
      "0.59999999999999998,0.69999999999999996\n");
}

/// A slash would divide the name of a group.
TEST(FrontFiles, TakeNamesWithASlash)
{
  const Folder folder;
  FrontFiles(folder.path()).write(1.0, {front("a/b", 2, 0.0)});
  EXPECT_EQ(Hdf5Reader(folder.path("fronts.h5")).numbers("/t00000/a_b.0/s"), (Numbers{0.0, 0.5}));
}

TEST(FrontFiles, AreNotThereWithoutFronts)
{
  const Folder folder;
  FrontFiles files(folder.path());
  files.write(0.5, {});
  files.write(0.75, {front("Ended", 0, 0.0)});
  files.sync();
  EXPECT_FALSE(exists(folder.path("fronts.h5")));
  EXPECT_FALSE(exists(folder.path("fronts.csv")));
}

TEST(FrontFiles, HaveEachTimeOnce)
{
  const Folder folder;
  FrontFiles files(folder.path());
  files.write(0.5, {front("Notch", 2, 1.0)});
  const std::string once = contents(folder.path("fronts.csv"));
  files.write(0.5, {front("Notch", 2, 1.0)});
  EXPECT_EQ(contents(folder.path("fronts.csv")), once);
  EXPECT_FALSE(Hdf5Reader(folder.path("fronts.h5")).has("/t00001"));
}

namespace
{

/// Files with three samples, and what a checkpoint saved after the first.
Record threeSamples(const Folder& folder)
{
  FrontFiles files(folder.path());
  files.write(1.0, {front("Notch", 2, 1.0)});
  Record record;
  Archive archive = Archive::saving(record);
  files.serialize(archive);
  files.write(2.0, {front("Notch", 3, 2.0)});
  files.write(3.0, {front("Notch", 4, 3.0)});
  return record;
}

} // namespace

TEST(FrontFiles, GoOnAfterACheckpoint)
{
  const Folder folder;
  const Record record = threeSamples(folder);
  const std::string whole = contents(folder.path("fronts.csv"));
  Archive archive = Archive::loading(record);
  FrontFiles files(folder.path(), archive);
  EXPECT_FALSE(Hdf5Reader(folder.path("fronts.h5")).has("/t00001"));
  EXPECT_LT(contents(folder.path("fronts.csv")).size(), whole.size());
  files.write(2.0, {front("Notch", 3, 2.0)});
  files.write(3.0, {front("Notch", 4, 3.0)});
  EXPECT_EQ(contents(folder.path("fronts.csv")), whole);
  const Hdf5Reader file(folder.path("fronts.h5"));
  EXPECT_EQ(file.attribute("/t00002", "time"), 3.0);
  EXPECT_EQ(file.numbers("/t00002/Notch.0/s"), (Numbers{0.0, 0.5, 1.0, 1.5}));
}

TEST(FrontFiles, DoNotGoOnWithThoseOfAnotherRun)
{
  const Folder folder;
  const Record record = threeSamples(folder);
  const std::string path = folder.path("fronts.csv");
  std::string text = contents(path);
  text[text.find("Notch")] = 'M';
  std::ofstream(path, std::ios::binary) << text;
  Archive archive = Archive::loading(record);
  EXPECT_THROW(FrontFiles(folder.path(), archive), OutputError);
  std::filesystem::remove(folder.path("fronts.h5"));
  Archive again = Archive::loading(record);
  EXPECT_THROW(FrontFiles(folder.path(), again), OutputError);
}

TEST(FrontFiles, SayWhereTheyCantBeWritten)
{
  FrontFiles files("/no/such/folder");
  EXPECT_THROW(files.write(1.0, {front("Notch", 2, 1.0)}), OutputError);
}
