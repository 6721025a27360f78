/// Files of fields that are damaged.

#include "SmallState.hpp"
#include "base/OutputError.hpp"
#include "output/Hdf5.hpp"

#include <hdf5.h>

using namespace Rhegma;

namespace
{

/// Values that no other part of the file has.
double valueOf(int frame, std::size_t row) { return 1234.5 + 1000.0 * frame + static_cast<double>(row); }

/// Three frames of a mesh with more tables than HDF5 lists in the header of a group.
void writeFrames(const std::string& path)
{
  constexpr std::size_t rows = 8;
  createHdf5(path);
  for (int frame = 0; frame < 3; ++frame)
  {
    Snapshot snapshot;
    snapshot.time = 0.5 * frame;
    OutputMesh mesh;
    mesh.name = "particles";
    for (int k = 0; k < 12; ++k)
    {
      DataSet data;
      data.name = "values" + std::to_string(k);
      for (std::size_t row = 0; row < rows; ++row)
        data.real.push_back(valueOf(frame, row));
      mesh.data.push_back(data);
    }
    snapshot.meshes.push_back(mesh);
    appendSnapshot(path, snapshotName(frame), snapshot);
  }
}

/// Changes one bit of the first table of a frame.
void damage(const std::string& path, int frame)
{
  std::string text = contents(path);
  const double value = valueOf(frame, 0);
  const std::size_t at = text.find(std::string(reinterpret_cast<const char*>(&value), sizeof value));
  ASSERT_NE(at, std::string::npos);
  text[at] = static_cast<char>(text[at] ^ 1);
  std::ofstream(path, std::ios::binary) << text;
}

std::string whyNotKept(const std::string& path, int count)
{
  try
  {
    keepSnapshots(path, count);
    return {};
  }
  catch (const OutputError& error)
  {
    return error.what();
  }
}

} // namespace

TEST(Hdf5, KeepsTheFirstSnapshots)
{
  const Folder folder;
  const std::string path = folder.path("fields.h5");
  writeFrames(path);
  EXPECT_EQ(whyNotKept(path, 2), "");
  EXPECT_EQ(whyNotKept(path, 3), "of its 3 frames t00002 is missing");
  EXPECT_EQ(whyNotKept(path, 2), "");
}

/// Also of a frame that is not kept: HDF5 may end the program where it removes what it can't read.
TEST(Hdf5, LeavesADamagedFileAsItIs)
{
  for (const int frame : {0, 2})
  {
    const Folder folder;
    const std::string path = folder.path("fields.h5");
    writeFrames(path);
    damage(path, frame);
    const std::string before = contents(path);
    EXPECT_EQ(whyNotKept(path, 2), "of its 3 frames the checksums show damage in " + snapshotName(frame));
    EXPECT_TRUE(contents(path) == before);
  }
}

TEST(Hdf5, SaysThatAFileCannotBeOpened)
{
  const Folder folder;
  std::ofstream(folder.path("fields.h5")) << "half a file";
  EXPECT_EQ(whyNotKept(folder.path("fields.h5"), 1), "HDF5 can't open it");
}

/// HDF5 can't close some of what is damaged, and would print that when the program ends.
TEST(Hdf5, StaysSilentAfterDamage)
{
  const Folder folder;
  const std::string path = folder.path("fields.h5");
  // Nodes of the index of names, and the heap that holds the names.
  for (const char* part : {"FHDB", "FRHP", "BTHD", "BTLF"})
    for (const int bit : {1, 9, 17, 40, 70, 100, 130})
    {
      writeFrames(path);
      std::string text = contents(path);
      const std::size_t at = text.find(part);
      ASSERT_NE(at, std::string::npos);
      text[at + bit / 8] = static_cast<char>(text[at + bit / 8] ^ (1 << bit % 8));
      std::ofstream(path, std::ios::binary) << text;
      EXPECT_NE(whyNotKept(path, 3), "") << part << " " << bit;
    }
  H5E_auto2_t print = nullptr;
  void* data = nullptr;
  H5Eget_auto2(H5E_DEFAULT, &print, &data);
  EXPECT_EQ(print, nullptr);
}
