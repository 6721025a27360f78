#include "Entries.hpp"

#include "checkpoint/CheckpointFile.hpp"
#include "plan/EffectSchema.hpp"
#include "scene/Scene.hpp"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <unistd.h>
#include <vector>
#include <zlib.h>

namespace Rhegma::fuzz
{

namespace
{

using Bytes = std::vector<std::uint8_t>;

/// A file in memory where there is such a position, which goes when this does.
class OwnFile
{
public:
  explicit OwnFile(const Bytes& bytes)
  {
    static const char* const folder = std::filesystem::is_directory("/dev/shm") ? "/dev/shm" : "/tmp";
    path_ = std::string(folder) + "/rhegma_fuzz_" + std::to_string(getpid());
    std::FILE* const file = std::fopen(path_.c_str(), "wb");
    if (file == nullptr || std::fwrite(bytes.data(), 1, bytes.size(), file) != bytes.size())
      std::abort(); // no position to work in is nothing that a fuzzer should count as read
    std::fclose(file);
  }
  ~OwnFile() { std::remove(path_.c_str()); }
  OwnFile(const OwnFile&) = delete;
  OwnFile& operator=(const OwnFile&) = delete;

  const std::string& path() const { return path_; }

private:
  std::string path_;
};

void put(Bytes& block, std::size_t at, int count, std::uint64_t value)
{
  for (int k = 0; k < count; ++k)
    block[at + k] = static_cast<std::uint8_t>(value >> (8 * k));
}

/// The first block of a checkpoint with this body (checkpoint/CheckpointFile.hpp).
Bytes blockBefore(const Bytes& body)
{
  Bytes block(512, 0);
  const std::uint8_t magic[] = {0x89, 'R', 'H', 'E',  'G',  'M',  'A',  ' ',
                                'c',  'h', 'k', '\r', '\n', 0x1a, '\n', 0};
  std::copy(std::begin(magic), std::end(magic), block.begin());
  put(block, 16, 4, checkpointSchema);
  put(block, 20, 4, crc32(crc32(0, nullptr, 0), body.data(), static_cast<uInt>(body.size())));
  put(block, 24, 8, body.size());
  put(block, 508, 4, crc32(0, block.data(), 508));
  return block;
}

} // namespace

void readScene(const std::uint8_t* bytes, std::size_t size)
{
  const std::string all(reinterpret_cast<const char*>(bytes), size);
  const std::size_t end = all.find('\0');
  std::vector<std::string> overrides;
  if (end != std::string::npos)
  {
    std::istringstream lines(all.substr(end + 1));
    for (std::string line; std::getline(lines, line);)
      overrides.push_back(line);
  }
  readSceneText(all.substr(0, end), overrides, effectSchema());
}

bool readCheckpoint(const std::uint8_t* bytes, std::size_t size)
{
  if (size == 0)
    return false;
  Bytes file(bytes + 1, bytes + size);
  if (bytes[0] % 2 == 1)
  {
    const Bytes block = blockBefore(file);
    file.insert(file.begin(), block.begin(), block.end());
  }
  const OwnFile own(file);
  try
  {
    Rhegma::readCheckpoint(own.path());
    return true;
  }
  catch (const std::invalid_argument&)
  {
    return false;
  }
}

} // namespace Rhegma::fuzz
