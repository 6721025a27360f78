#include "cracks/CutTriangles.hpp"

#include "geometry/Cross.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace Rhegma::cracks
{

namespace
{

/// Twice the area with its direction; in a plane the other two components are zero.
template <int D>
Vector<3> areaOf(const std::vector<Vector<D>>& points, const std::array<int, 3>& t)
{
  Vector<3> a{0.0, 0.0, 0.0}, b{0.0, 0.0, 0.0};
  for (int d = 0; d < D; ++d)
  {
    a[d] = points[t[1]][d] - points[t[0]][d];
    b[d] = points[t[2]][d] - points[t[0]][d];
  }
  return cross(a, b);
}

} // namespace

template <int D>
void cutTriangles(std::vector<Vector<D>>& points, std::vector<std::array<int, 3>>& triangles,
                  const std::function<bool(const Vector<D>&)>& isIn)
{
  enum Place
  {
    Outside,
    OnBorder,
    Inside
  };
  constexpr double near = 0.3; // part of an edge within which its end moves onto the border
  std::vector<Vector<D>> cutPoints = points;
  std::vector<std::array<int, 3>> kept;
  std::vector<Place> place;
  place.reserve(points.size());
  for (const Vector<D>& x : points)
    place.push_back(isIn(x) ? Inside : Outside);
  const std::vector<Place> before = place;
  const auto crossing = [&](int in, int out)
  {
    Vector<D> a = points[in], b = points[out];
    for (int halving = 0; halving < 10; ++halving)
    {
      const Vector<D> middle = 0.5 * (a + b);
      (isIn(middle) ? a : b) = middle;
    }
    return a;
  };
  // A corner of the surface's own border stays on that, or its border would be no front there.
  std::map<std::pair<int, int>, int> uses;
  for (const std::array<int, 3>& t : triangles)
    for (int i = 0; i < 3; ++i)
      ++uses[std::minmax(t[i], t[(i + 1) % 3])];
  std::vector<char> atBorder(points.size(), 0);
  for (const auto& [edge, triangleCount] : uses)
    if (triangleCount == 1)
      atBorder[edge.first] = atBorder[edge.second] = 1;
  std::map<std::pair<int, int>, Vector<D>> crossings; // of edges (inner end, outer end)
  std::vector<double> moved(place.size(), 1e300);
  for (const std::array<int, 3>& t : triangles)
    for (int i = 0; i < 3; ++i)
      for (const auto& [in, out] :
           {std::make_pair(t[i], t[(i + 1) % 3]), std::make_pair(t[(i + 1) % 3], t[i])})
        if (before[in] == Inside && before[out] == Outside && crossings.count({in, out}) == 0)
        {
          const Vector<D> x = crossing(in, out);
          crossings[{in, out}] = x;
          const double length = norm(points[out] - points[in]);
          for (const int end : {in, out})
          {
            const double way = norm(x - points[end]);
            if (atBorder[end] != 0 && uses.at(std::minmax(in, out)) != 1)
              continue;
            if (way < near * length && way < moved[end])
            {
              moved[end] = way;
              cutPoints[end] = x;
              place[end] = OnBorder;
            }
          }
        }
  // Moved corners may have turned a triangle over.
  const auto hasArea = [&](const std::array<int, 3>& old, const std::array<int, 3>& left)
  { return dot(areaOf(points, old), areaOf(cutPoints, left)) > 0.0; };
  std::map<std::pair<int, int>, int> added;
  const auto between = [&](int in, int out)
  {
    const auto [entry, isNew] = added.insert({{in, out}, static_cast<int>(cutPoints.size())});
    if (isNew)
      cutPoints.push_back(crossings.at({in, out}));
    return entry->second;
  };
  for (const std::array<int, 3>& t : triangles)
  {
    // The polygon that is left of the triangle, corner by corner.
    std::vector<int> left;
    bool inside = false;
    for (int i = 0; i < 3; ++i)
    {
      const int a = t[i], b = t[(i + 1) % 3];
      inside = inside || place[a] == Inside;
      if (place[a] != Outside)
        left.push_back(a);
      if (place[a] == Inside && place[b] == Outside)
        left.push_back(between(a, b));
      if (place[a] == Outside && place[b] == Inside)
        left.push_back(between(b, a));
    }
    if (!inside && left.size() == 3)
      inside = isIn((1.0 / 3.0) * (points[t[0]] + points[t[1]] + points[t[2]]));
    for (std::size_t k = 2; inside && k < left.size(); ++k)
      if (hasArea(t, {left[0], left[k - 1], left[k]}))
        kept.push_back({left[0], left[k - 1], left[k]});
  }
  // Points that no triangle uses any more.
  std::vector<int> number(cutPoints.size(), -1);
  std::vector<Vector<D>> used;
  for (std::array<int, 3>& t : kept)
    for (int& v : t)
    {
      if (number[v] < 0)
      {
        number[v] = static_cast<int>(used.size());
        used.push_back(cutPoints[v]);
      }
      v = number[v];
    }
  points = used;
  triangles = kept;
}

template void cutTriangles(std::vector<Vector<2>>&, std::vector<std::array<int, 3>>&,
                           const std::function<bool(const Vector<2>&)>&);
template void cutTriangles(std::vector<Vector<3>>&, std::vector<std::array<int, 3>>&,
                           const std::function<bool(const Vector<3>&)>&);

} // namespace Rhegma::cracks
