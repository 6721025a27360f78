#include "geometry/ShapeFile.hpp"

#include "geometry/MendSurface.hpp"
#include "geometry/OutlineFile.hpp"
#include "geometry/SurfaceFile.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
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

Version versionOf(const std::string& path)
{
  std::error_code error; // of a file that is missing: reading it says so
  return {std::filesystem::last_write_time(path, error), std::filesystem::file_size(path, error)};
}

template <int D>
MendedSurface<D> readMended(const std::string& path)
{
  if constexpr (D == 3)
    return mendSurface(readSurfaceFile(path));
  else
    return mendOutlines(parseOutlines(readBytes(path)));
}

/// Adds the path to messages about the content.
template <int D>
SolidOfFile<D> read(const std::string& path)
{
  try
  {
    MendedSurface<D> mended = readMended<D>(path);
    return {std::make_shared<const Solid<D>>(std::move(mended.surface), mended.resolution),
            std::move(mended.notes)};
  }
  catch (const std::invalid_argument& wrong)
  {
    const std::string message = wrong.what();
    throw std::invalid_argument(message.compare(0, path.size(), path) == 0 ? message : path + ": " + message);
  }
}

} // namespace

template <int D>
SolidOfFile<D> readSolid(const std::string& path)
{
  struct Entry
  {
    Version version;
    SolidOfFile<D> solid;
    long used;
  };
  static std::mutex mutex;
  static std::map<std::string, Entry> entries;
  static long uses = 0;
  constexpr std::size_t most = 32;
  const std::lock_guard<std::mutex> lock(mutex);
  const Version version = versionOf(path);
  const auto known = entries.find(path);
  if (known != entries.end() && known->second.version == version)
  {
    known->second.used = ++uses;
    return known->second.solid;
  }
  SolidOfFile<D> solid = read<D>(path);
  entries[path] = {version, solid, ++uses};
  if (entries.size() > most)
    entries.erase(std::min_element(entries.begin(), entries.end(),
                                   [](const auto& a, const auto& b)
                                   { return a.second.used < b.second.used; }));
  return solid;
}

template SolidOfFile<2> readSolid(const std::string&);
template SolidOfFile<3> readSolid(const std::string&);

} // namespace Rhegma::Geometry
