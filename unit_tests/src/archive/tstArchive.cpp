/// One description saves and loads; what does not fit is refused by its name.

#include "archive/Archive.hpp"
#include "checkpoint/CheckpointFile.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <unistd.h>
#include <vector>

using namespace Rhegma;

namespace
{

/// One of everything that an archive takes.
struct Memory
{
  double real = 0.0;
  int whole = 0;
  long large = 0;
  bool flag = false;
  std::string text;
  std::vector<std::string> texts;
  std::vector<double> list;
  std::vector<int> pairs;
  Vector<3> vector{};
  int numbers[3] = {};
  View<double* [2]> table;
  View<double** [2]> block;
  View<int[2]> fixed;
  View<char*> marks;
  View<std::uint64_t*> keys;

  void serialize(Archive& archive)
  {
    archive("real", real);
    archive("whole", whole);
    archive("large", large);
    archive("flag", flag);
    archive("text", text);
    archive("texts", texts);
    archive("list", list);
    archive("pairs", pairs, 2);
    const Archive::Group group(archive, "inside");
    archive("vector", vector);
    archive("numbers", numbers);
    archive("table", table);
    archive("block", block);
    archive("fixed", fixed);
    archive("marks", marks);
    archive("keys", keys);
  }
};

Memory some()
{
  Memory m;
  m.real = std::nextafter(0.1, 1.0);
  m.whole = -7;
  m.large = 5'000'000'000;
  m.flag = true;
  m.text = "two\nlines";
  m.texts = {"", "a", "b / c"};
  m.list = {std::numeric_limits<double>::quiet_NaN(), -0.0, 1e-310};
  m.pairs = {1, 2, 3, 4};
  m.vector = {{1.0, 2.0, 3.0}};
  m.numbers[2] = 9;
  m.table = View<double* [2]>("table", 3);
  m.block = View<double** [2]>("block", 2, 2);
  m.marks = View<char*>("marks", 5);
  m.keys = View<std::uint64_t*>("keys", 1);
  Kokkos::deep_copy(m.table, 0.5);
  Kokkos::deep_copy(m.block, 0.25);
  Kokkos::deep_copy(m.marks, 'x');
  Kokkos::deep_copy(m.keys, ~std::uint64_t(0));
  return m;
}

Record recordOf(Memory memory)
{
  Record record;
  Archive archive = Archive::saving(record);
  memory.serialize(archive);
  return record;
}

std::string errorOf(const Record& record)
{
  try
  {
    Archive archive = Archive::loading(record);
    Memory().serialize(archive);
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return {};
}

std::string path() { return "rhegma_archive_" + std::to_string(getpid()) + ".h5"; }

} // namespace

TEST(Archive, LoadsWhatItSaved)
{
  const Record record = recordOf(some());
  Archive archive = Archive::loading(record);
  Memory loaded;
  loaded.table = View<double* [2]>("table", 77); // another size
  loaded.serialize(archive);
  EXPECT_EQ(recordOf(loaded), record); // every bit, those of NaN and -0 too
  EXPECT_EQ(loaded.texts, some().texts);
  EXPECT_EQ(loaded.table.extent(0), 3U);
}

TEST(Archive, SavesWhatIsNotThereYet)
{
  const Record record = recordOf(Memory());
  Archive archive = Archive::loading(record);
  Memory loaded = some();
  loaded.serialize(archive);
  EXPECT_EQ(loaded.table.extent(0), 0U);
  EXPECT_TRUE(loaded.list.empty());
}

TEST(Archive, NamesWhatDoesNotFit)
{
  Record record = recordOf(some());
  record.erase("inside/table");
  EXPECT_EQ(errorOf(record), "\"inside/table\" is missing");
  record = recordOf(some());
  record["whole"].type = RecordTable::Type::Real;
  EXPECT_EQ(errorOf(record), "\"whole\" is of another type");
  record = recordOf(some());
  record["inside/table"].extent = {2, 3};
  EXPECT_EQ(errorOf(record), "\"inside/table\" has another shape");
  record = recordOf(some());
  record["pairs"].extent = {4};
  EXPECT_EQ(errorOf(record), "\"pairs\" has another shape");
  record = recordOf(some());
  record["list"].bytes.pop_back();
  EXPECT_EQ(errorOf(record), "\"list\" has another size than its header says");
}

TEST(CheckpointFile, BringsARecordBack)
{
  Record record = recordOf(some());
  record["a/b/c/deep"] = record["real"]; // groups in groups, some of which only lead on
  writeCheckpoint(path(), record);
  EXPECT_EQ(readCheckpoint(path()), record);
  record.erase("real");
  writeCheckpoint(path(), record); // replaces the older one
  EXPECT_EQ(readCheckpoint(path()), record);
  std::remove(path().c_str());
}

TEST(CheckpointFile, IsTheSameForTheSameState)
{
  const auto bytes = [](const std::string& file)
  {
    std::vector<char> all(1 << 20);
    std::FILE* open = std::fopen(file.c_str(), "rb");
    all.resize(std::fread(all.data(), 1, all.size(), open));
    std::fclose(open);
    return all;
  };
  writeCheckpoint(path(), recordOf(some()));
  const std::vector<char> first = bytes(path());
  writeCheckpoint(path(), recordOf(some()));
  EXPECT_EQ(bytes(path()), first);
  EXPECT_GT(first.size(), 512U);
  std::remove(path().c_str());
}
