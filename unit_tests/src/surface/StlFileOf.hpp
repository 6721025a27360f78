#pragma once
/// Surfaces as files for tests.

#include "surface/SurfaceMesh.hpp"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

namespace Rhegma::surface::test
{

inline std::string binaryStl(const SurfaceMesh& mesh)
{
  std::string bytes(80, ' ');
  const auto append = [&](const void* data, std::size_t size)
  { bytes.append(static_cast<const char*>(data), size); };
  const std::uint32_t count = static_cast<std::uint32_t>(mesh.triangles.size());
  append(&count, sizeof count);
  for (const auto& t : mesh.triangles)
  {
    float numbers[12] = {};
    for (int i = 0; i < 3; ++i)
      for (int d = 0; d < 3; ++d)
        numbers[3 + 3 * i + d] = static_cast<float>(mesh.points[t[i]][d]);
    append(numbers, sizeof numbers);
    bytes.append(2, '\0');
  }
  return bytes;
}

/// A file that is removed with this object.
struct File
{
  std::string path;
  File(const std::string& name, const std::string& bytes)
      : path((std::filesystem::temp_directory_path() / ("rhegma_" + name)).string())
  {
    std::ofstream(path, std::ios::binary) << bytes;
  }
  ~File() { std::filesystem::remove(path); }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
};

} // namespace Rhegma::surface::test
