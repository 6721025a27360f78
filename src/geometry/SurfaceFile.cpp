#include "geometry/SurfaceFile.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace Rhegma::Geometry
{

namespace
{

constexpr std::uintmax_t mostBytes = 500000000; // far more than a crack has

} // namespace

std::string readBytes(const std::string& path)
{
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    throw std::invalid_argument(path + ": there is no such file");
  if (std::filesystem::file_size(path, error) > mostBytes)
    throw std::invalid_argument(path + ": the file has more than 500 MB; give a shape with fewer points");
  std::ifstream file(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file)
    throw std::invalid_argument(path + ": the file can't be read");
  if (bytes.empty())
    throw std::invalid_argument(path + ": the file is empty");
  return bytes;
}

std::size_t textBegin(const std::string& text)
{
  const std::string mark = "\xEF\xBB\xBF";
  return text.compare(0, mark.size(), mark) == 0 ? mark.size() : 0;
}

SurfaceMesh readSurfaceFile(const std::string& path)
{
  std::string end = std::filesystem::path(path).extension().string();
  std::transform(end.begin(), end.end(), end.begin(), [](unsigned char c) { return std::tolower(c); });
  if (end != ".stl" && end != ".obj")
    throw std::invalid_argument(path + ": a surface comes from a file whose name ends in .stl or .obj");
  const std::string bytes = readBytes(path);
  try
  {
    SurfaceMesh mesh = end == ".stl" ? parseStl(bytes) : parseObj(bytes);
    if (mesh.triangles.empty())
      throw std::invalid_argument("the file holds no triangle");
    return mesh;
  }
  catch (const std::invalid_argument& wrong)
  {
    throw std::invalid_argument(path + ": " + wrong.what());
  }
}

} // namespace Rhegma::Geometry
