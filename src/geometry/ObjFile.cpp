#include "geometry/SurfaceFile.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace Rhegma::Geometry
{

namespace
{

std::string lineName(int line) { return "line " + std::to_string(line) + " "; }

/// The point of a corner of a face: "7", "7/1/3" or, counted back from the last, "-2".
int pointOf(const std::string& corner, int points, int line)
{
  std::size_t used = 0;
  int number = 0;
  try
  {
    number = std::stoi(corner, &used);
  }
  catch (const std::logic_error&)
  {
    used = 0;
  }
  const int point = number > 0 ? number - 1 : points + number;
  if (used == 0 || (used < corner.size() && corner[used] != '/') || number == 0 || point < 0 ||
      point >= points)
    throw std::invalid_argument(lineName(line) + "names a point \"" + corner + "\" that is not there");
  return point;
}

} // namespace

SurfaceMesh parseObj(const std::string& text)
{
  SurfaceMesh mesh;
  std::istringstream lines(text.substr(textBegin(text)));
  std::string line, word;
  for (int number = 1; std::getline(lines, line); ++number)
  {
    std::istringstream words(line);
    if (!(words >> word))
      continue;
    if (word == "v")
    {
      Vector<3> x{0.0, 0.0, 0.0};
      if (!(words >> x[0] >> x[1] >> x[2]) || !std::isfinite(x[0] + x[1] + x[2]))
        throw std::invalid_argument(lineName(number) + "is a point without three numbers");
      mesh.points.push_back(x);
    }
    else if (word == "f")
    {
      std::vector<int> corners;
      while (words >> word)
        corners.push_back(pointOf(word, static_cast<int>(mesh.points.size()), number));
      if (corners.size() < 3)
        throw std::invalid_argument(lineName(number) + "is a face with less than three corners");
      for (std::size_t k = 2; k < corners.size(); ++k)
        mesh.triangles.push_back({corners[0], corners[k - 1], corners[k]});
    }
  }
  return mesh;
}

} // namespace Rhegma::Geometry
