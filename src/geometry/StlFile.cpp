#include "geometry/SurfaceFile.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <stdexcept>

namespace Rhegma::Geometry
{

namespace
{

constexpr std::size_t header = 80, perTriangle = 50; // bytes of a binary file

void append(SurfaceMesh& mesh, const Vector<3> (&corner)[3])
{
  const int first = static_cast<int>(mesh.points.size());
  for (const Vector<3>& x : corner)
  {
    if (!std::isfinite(x[0] + x[1] + x[2]))
      throw std::invalid_argument("triangle " + std::to_string(mesh.triangles.size() + 1) +
                                  " has a coordinate that is no number");
    mesh.points.push_back(x);
  }
  mesh.triangles.push_back({first, first + 1, first + 2});
}

std::uint32_t countOf(const std::string& bytes)
{
  std::uint32_t count = 0; // files are little-endian, as are the machines that this is built for
  std::memcpy(&count, bytes.data() + header, sizeof count);
  return count;
}

SurfaceMesh parseBinary(const std::string& bytes)
{
  const std::size_t count = countOf(bytes);
  if (bytes.size() < header + 4 + count * perTriangle)
    throw std::invalid_argument("the file is cut short: it says that it has " + std::to_string(count) +
                                " triangles, but holds " +
                                std::to_string((bytes.size() - header - 4) / perTriangle));
  if (bytes.size() >= header + 4 + (count + 1) * perTriangle)
    throw std::invalid_argument("the file says that it has " + std::to_string(count) +
                                " triangles, but has space for " +
                                std::to_string((bytes.size() - header - 4) / perTriangle) +
                                "; write the file again, or correct the number");
  SurfaceMesh mesh;
  for (std::size_t t = 0; t < count; ++t)
  {
    float numbers[12]; // the normal, then the corners
    std::memcpy(numbers, bytes.data() + header + 4 + t * perTriangle, sizeof numbers);
    Vector<3> corner[3];
    for (int i = 0; i < 3; ++i)
      for (int d = 0; d < 3; ++d)
        corner[i][d] = numbers[3 + 3 * i + d];
    append(mesh, corner);
  }
  return mesh;
}

/// Some programs write the words of a file in capitals.
std::string inLowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// Skips the name of a solid, which may contain any words.
void skipLine(std::istringstream& words)
{
  for (int c = words.get(); c != '\n' && c != '\r' && words.good();)
    c = words.get();
}

SurfaceMesh parseAscii(const std::string& text)
{
  SurfaceMesh mesh;
  std::istringstream words(text);
  std::string word;
  Vector<3> corner[3];
  int corners = 0;
  bool ended = false;
  while (words >> word)
  {
    word = inLowerCase(word);
    if (word == "vertex")
    {
      Vector<3> x{0.0, 0.0, 0.0};
      if (corners == 3 || !(words >> x[0] >> x[1] >> x[2]))
        throw std::invalid_argument("triangle " + std::to_string(mesh.triangles.size() + 1) +
                                    " has no three corners of three numbers");
      corner[corners++] = x;
    }
    else if (word == "endloop")
    {
      if (corners != 3)
        throw std::invalid_argument("triangle " + std::to_string(mesh.triangles.size() + 1) +
                                    " has no three corners of three numbers");
      append(mesh, corner);
      corners = 0;
    }
    else if (word == "solid" || word == "endsolid")
    {
      ended = word == "endsolid";
      skipLine(words);
    }
  }
  if (!ended || corners != 0)
    throw std::invalid_argument("the file is cut short: it has no \"endsolid\"");
  return mesh;
}

} // namespace

SurfaceMesh parseStl(const std::string& text)
{
  const std::size_t begin = text.find_first_not_of(" \t\r\n", textBegin(text));
  const bool solid = begin != std::string::npos && inLowerCase(text.substr(begin, 5)) == "solid";
  // Some binary files begin with "solid" too; they are recognised by their length, or by a zero byte, which
  // no text has.
  const bool fits = text.size() >= header + 4 && text.size() == header + 4 + countOf(text) * perTriangle;
  if (solid && !fits && text.find('\0') == std::string::npos)
    return parseAscii(text.substr(begin));
  if (!text.empty() && text.find('\0') == std::string::npos)
    throw std::invalid_argument("the file is no STL file: it is a text that does not begin with \"solid\"");
  if (text.size() < header + 4)
    throw std::invalid_argument("the file is cut short: a binary STL file has at least 84 bytes");
  return parseBinary(text);
}

} // namespace Rhegma::Geometry
