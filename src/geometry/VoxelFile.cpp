#include "geometry/VoxelFile.hpp"

#include "base/ShortNumber.hpp"
#include "geometry/NpyHeader.hpp"
#include "geometry/PictureFile.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <stdexcept>
#include <tuple>

namespace Rhegma::Geometry
{

namespace
{

/// A version of a file, by which a change is noticed.
using Version = std::tuple<std::filesystem::file_time_type, std::uintmax_t>;

/// Of a folder, the latest of its pictures and the size of all.
Version versionOf(const std::string& path)
{
  std::error_code error; // of a file that is missing: reading it says so
  Version version{std::filesystem::last_write_time(path, error), 0};
  for (const std::string& file : filesOfPictures(path))
  {
    std::get<0>(version) = std::max(std::get<0>(version), std::filesystem::last_write_time(file, error));
    std::get<1>(version) += std::filesystem::file_size(file, error);
  }
  return version;
}

std::string timesOf(const std::vector<std::int64_t>& shape)
{
  std::string text;
  for (const std::int64_t count : shape)
    text += (text.empty() ? "" : " x ") + std::to_string(count);
  return text;
}

/// Rejects an image of the wrong number of axes, without voxels, cut off, or too large for the memory.
template <int D>
void checkSize(const NpyHeader& header, std::uintmax_t size, double available)
{
  if (header.shape.size() != D)
    throw std::invalid_argument("the array has " + std::to_string(header.shape.size()) +
                                " axes, but a scene in " + std::to_string(D) + "D needs " +
                                std::to_string(D) + (D == 2 ? ": x and y" : ": x, y and z"));
  double voxels = 1.0;
  for (const std::int64_t count : header.shape)
    voxels *= static_cast<double>(count);
  if (voxels == 0.0)
    throw std::invalid_argument("the array has no voxels (" + timesOf(header.shape) + ")");
  const double need = voxels * sizeof(std::int16_t);
  if (need > available)
    throw std::invalid_argument(
        "an image of " + timesOf(header.shape) + " voxels needs " + formatShort(need * 1e-9) +
        " GB of memory for each body that it makes, but only " + formatShort(available * 1e-9) +
        " GB are free; cut the image, or merge voxels into larger ones");
  if (static_cast<double>(size) <
      static_cast<double>(header.dataBegin) + voxels * static_cast<double>(header.bytes))
    throw std::invalid_argument("the file is cut off: it is smaller than its " + timesOf(header.shape) +
                                " voxels; write it again");
}

/// A number of the file.
std::int64_t numberAt(const unsigned char* from, const NpyHeader& header)
{
  std::uint64_t bits = 0;
  for (std::size_t k = 0; k < header.bytes; ++k)
    bits |= static_cast<std::uint64_t>(from[header.isBigEndian ? header.bytes - 1 - k : k]) << (8 * k);
  const unsigned unused = 64 - 8 * static_cast<unsigned>(header.bytes);
  return header.isSigned ? static_cast<std::int64_t>(bits << unused) >> unused
                         : static_cast<std::int64_t>(bits);
}

/// How many voxels have each value, for a message.
std::string listOf(const std::map<std::int64_t, std::int64_t>& counts)
{
  constexpr std::size_t most = 12;
  std::string text;
  std::size_t number = 0;
  for (const auto& [value, count] : counts)
    if (++number <= most)
      text += (number == 1 ? "" : ", ") + std::to_string(value) + " (" + std::to_string(count) + " voxels)";
  return text +
         (counts.size() > most ? " and " + std::to_string(counts.size() - most) + " other values" : "");
}

/// Marks which voxels have a value, and counts those of all values.
class Marks
{
public:
  Marks(std::size_t voxels, int value) : value_(value) { inside_.reserve(voxels); }

  void add(std::int64_t number)
  {
    if (last_ == counts_.end() || last_->first != number) // neighbours mostly have one value
      last_ = counts_.emplace(number, 0).first;
    ++last_->second;
    inside_.push_back(number == value_ ? 1 : -1);
  }

  /// For each voxel 1 where it has the value, else -1.
  std::vector<std::int16_t> take()
  {
    if (counts_.count(value_) == 0)
      throw std::invalid_argument("no voxel has the value " + std::to_string(value_) + "; it has " +
                                  listOf(counts_));
    return std::move(inside_);
  }

private:
  int value_;
  std::vector<std::int16_t> inside_;
  std::map<std::int64_t, std::int64_t> counts_;
  std::map<std::int64_t, std::int64_t>::iterator last_ = counts_.end();
};

std::vector<std::int16_t> readInside(std::istream& file, const NpyHeader& header, std::size_t voxels,
                                     int value)
{
  constexpr std::size_t block = 1 << 20;
  Marks marks(voxels, value);
  std::vector<unsigned char> bytes(std::min(block, voxels) * header.bytes);
  file.seekg(static_cast<std::streamoff>(header.dataBegin));
  for (std::size_t begin = 0; begin < voxels; begin += block)
  {
    const std::size_t here = std::min(block, voxels - begin);
    file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(here * header.bytes));
    if (!file)
      throw std::invalid_argument("the file can't be read to its end");
    for (std::size_t k = 0; k < here; ++k)
      marks.add(numberAt(bytes.data() + k * header.bytes, header));
  }
  return marks.take();
}

template <int D>
std::shared_ptr<const VoxelPhase<D>> readNpy(const std::string& path, int value, double available)
{
  std::ifstream file(path, std::ios::binary);
  if (!file)
    throw std::invalid_argument("the file can't be read");
  const NpyHeader header = readNpyHeader(file);
  checkSize<D>(header, std::filesystem::file_size(path), available);
  typename VoxelPhase<D>::Index count;
  std::size_t voxels = 1;
  for (int d = 0; d < D; ++d)
  {
    count[d] = header.shape[d];
    voxels *= static_cast<std::size_t>(count[d]);
  }
  return std::make_shared<const VoxelPhase<D>>(count, readInside(file, header, voxels, value));
}

template <int D>
std::shared_ptr<const VoxelPhase<D>> readPhaseOfPictures(const std::string& path, int value, double available)
{
  const Pictures pictures = readPictures(path, available);
  if (D == 2 && pictures.count[2] != 1)
    throw std::invalid_argument("it has " + std::to_string(pictures.count[2]) +
                                " pictures, but a scene in 2D needs one");
  typename VoxelPhase<D>::Index count;
  std::copy(pictures.count.begin(), pictures.count.begin() + D, count.begin());
  Marks marks(pictures.grey.size(), value);
  for (const std::uint16_t grey : pictures.grey)
    marks.add(grey);
  return std::make_shared<const VoxelPhase<D>>(count, marks.take());
}

template <int D>
std::shared_ptr<const VoxelPhase<D>> read(const std::string& path, int value, double available)
{
  try
  {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error) && !std::filesystem::is_directory(path, error))
      throw std::invalid_argument("there is no such file");
    return isOfPictures(path) ? readPhaseOfPictures<D>(path, value, available)
                              : readNpy<D>(path, value, available);
  }
  catch (const std::invalid_argument& wrong)
  {
    throw std::invalid_argument(path + ": " + wrong.what());
  }
}

} // namespace

template <int D>
std::shared_ptr<const VoxelPhase<D>> readVoxels(const std::string& path, int value, double available)
{
  struct Entry
  {
    Version version;
    std::shared_ptr<const VoxelPhase<D>> phase;
    long used;
  };
  static std::mutex mutex;
  static std::map<std::pair<std::string, int>, Entry> entries;
  static long uses = 0;
  constexpr std::size_t most = 32;
  const std::lock_guard<std::mutex> lock(mutex);
  const Version version = versionOf(path);
  const auto known = entries.find({path, value});
  if (known != entries.end() && known->second.version == version)
  {
    known->second.used = ++uses;
    return known->second.phase;
  }
  std::shared_ptr<const VoxelPhase<D>> phase = read<D>(path, value, available);
  entries[{path, value}] = {version, phase, ++uses};
  if (entries.size() > most)
    entries.erase(std::min_element(entries.begin(), entries.end(),
                                   [](const auto& a, const auto& b)
                                   { return a.second.used < b.second.used; }));
  return phase;
}

template std::shared_ptr<const VoxelPhase<2>> readVoxels(const std::string&, int, double);
template std::shared_ptr<const VoxelPhase<3>> readVoxels(const std::string&, int, double);

} // namespace Rhegma::Geometry
