#include "surface/Polyline.hpp"

#include "surface/NearestOnSimplex.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::surface
{

namespace
{

using Points = std::vector<Vector<2>>;

/// Whether the segments a-b and c-d have a point in common.
bool meet(const Vector<2>& a, const Vector<2>& b, const Vector<2>& c, const Vector<2>& d, double tolerance)
{
  const auto turn = [](const Vector<2>& p, const Vector<2>& q, const Vector<2>& r)
  { return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]); };
  if (turn(a, b, c) * turn(a, b, d) < 0.0 && turn(c, d, a) * turn(c, d, b) < 0.0)
    return true;
  return std::min({distanceToSegment(a, c, d), distanceToSegment(b, c, d), distanceToSegment(c, a, b),
                   distanceToSegment(d, a, b)}) < tolerance;
}

double lengthBetween(const Points& points, std::size_t first, std::size_t last, double from)
{
  for (std::size_t k = first; k < last; ++k)
    from += norm(points[k + 1] - points[k]);
  return from;
}

} // namespace

Points splitSegments(const Points& points, double longest)
{
  Points fine{points.front()};
  for (std::size_t k = 1; k < points.size(); ++k)
  {
    const Vector<2> along = points[k] - points[k - 1];
    const int pieces = std::max(1, static_cast<int>(std::ceil(norm(along) / longest - 1e-9)));
    for (int i = 1; i <= pieces; ++i)
      fine.push_back(points[k - 1] + (double(i) / pieces) * along);
  }
  return fine;
}

std::array<int, 2> firstCrossing(const Points& points, double tolerance)
{
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    for (std::size_t j = i + 1; j + 1 < points.size(); ++j)
      // Neighbours have a common point; they overlap if the end of one lies on the other.
      if (j == i + 1 ? distanceToSegment(points[j + 1], points[i], points[j]) < tolerance ||
                           distanceToSegment(points[i], points[j], points[j + 1]) < tolerance
                     : meet(points[i], points[i + 1], points[j], points[j + 1], tolerance))
        return {static_cast<int>(i), static_cast<int>(j)};
  return {-1, -1};
}

Points clipEnds(const Points& points, const Region<2>& region, double resolution)
{
  if (region(points.front()) && region(points.back())) // as of most cracks
    return points;
  const Points dense = splitSegments(points, resolution);
  std::size_t first = 0, last = dense.size();
  while (first < dense.size() && !region(dense[first]))
    ++first;
  while (last > first && !region(dense[last - 1]))
    --last;
  if (last < first + 2)
    return {};
  // Keep the given points between the two ends.
  Points kept{dense[first]};
  const double rounding = 1e-7 * resolution, from = lengthBetween(dense, 0, first, 0.0),
               to = lengthBetween(dense, first, last - 1, from);
  double at = 0.0;
  for (std::size_t k = 1; k + 1 < points.size(); ++k)
  {
    at += norm(points[k] - points[k - 1]);
    if (at > from + rounding && at < to - rounding)
      kept.push_back(points[k]);
  }
  kept.push_back(dense[last - 1]);
  return kept;
}

CrackMesh<2> polylineMesh(const Points& points, const std::array<int, 2>& beyond)
{
  CrackMesh<2> mesh;
  mesh.vertices = points;
  const int segments = static_cast<int>(points.size()) - 1;
  for (int s = 0; s < segments; ++s)
  {
    mesh.simplices.push_back({s, s + 1});
    mesh.beyond.push_back({s + 1, s - 1});
  }
  mesh.beyond.front()[1] = beyond[0];
  mesh.beyond.back()[0] = beyond[1];
  return mesh;
}

} // namespace Rhegma::surface
