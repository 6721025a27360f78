/// The corpus of the fuzzers, through the same entry points: what once was a finding stays mended.

#include "Entries.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

using namespace Rhegma;

namespace
{

using Bytes = std::vector<std::uint8_t>;

std::vector<Bytes> corpus(const std::string& name)
{
  std::vector<Bytes> all;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(RHEGMA_SOURCE_DIR) +
                                                               "/unit_tests/fuzz/corpus/" + name))
  {
    std::ifstream in(entry.path(), std::ios::binary);
    all.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  return all;
}

} // namespace

TEST(Corpus, OfScenesIsReadWithoutAnException)
{
  const std::vector<Bytes> scenes = corpus("scene");
  ASSERT_GT(scenes.size(), 10u);
  for (const Bytes& bytes : scenes)
    EXPECT_NO_THROW(fuzz::readScene(bytes.data(), bytes.size()));
}

/// Some are good and some are not, or the reader is not reached.
TEST(Corpus, OfCheckpointsIsReadOrRefused)
{
  const std::vector<Bytes> files = corpus("checkpoint");
  ASSERT_GT(files.size(), 3u);
  std::size_t good = 0;
  for (const Bytes& bytes : files)
    EXPECT_NO_THROW(good += fuzz::readCheckpoint(bytes.data(), bytes.size()) ? 1 : 0);
  EXPECT_GT(good, 0u);
  EXPECT_LT(good, files.size());
}
