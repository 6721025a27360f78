#include "geometry/MergePoints.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <numeric>

namespace Rhegma::Geometry
{

namespace
{

std::size_t hashOf(const Vector<3>& x)
{
  std::uint64_t hash = 0;
  for (int d = 0; d < 3; ++d)
  {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &x[d], sizeof bits);
    hash = (hash ^ bits) * 0x9e3779b97f4a7c15ull; // multiplicative hashing by the golden ratio
    hash ^= hash >> 29;
  }
  return static_cast<std::size_t>(hash);
}

/// Groups of points, each named by its smallest member.
class Groups
{
public:
  explicit Groups(std::size_t count) : of_(count) { std::iota(of_.begin(), of_.end(), 0); }

  int find(int point)
  {
    while (of_[point] != point)
      point = of_[point] = of_[of_[point]];
    return point;
  }

  /// \return whether they were in different groups
  bool unite(int a, int b)
  {
    a = find(a);
    b = find(b);
    of_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

private:
  std::vector<int> of_;
};

void unite(const Simplices<3>& surface, int a, int b, Groups& groups, MergedPoints& merged)
{
  if (!groups.unite(a, b))
    return;
  if (merged.pairs++ == 0)
    merged.at = surface.points[a];
  merged.farthest = std::max(merged.farthest, norm(surface.points[a] - surface.points[b]));
}

void rename(Simplices<3>& surface, Groups& groups)
{
  for (auto& item : surface.items)
    for (int& point : item)
      point = groups.find(point);
}

} // namespace

Simplices<3> mergeEqualPoints(const SurfaceMesh& mesh)
{
  std::size_t size = 16;
  while (size < 2 * mesh.points.size())
    size *= 2;
  std::vector<int> table(size, -1); // open addressing
  Simplices<3> surface;
  surface.items.reserve(mesh.triangles.size());
  const auto numberOf = [&](Vector<3> x)
  {
    for (int d = 0; d < 3; ++d)
      x[d] += 0.0; // a negative zero is the same as zero
    std::size_t at = hashOf(x) & (size - 1);
    for (; table[at] >= 0; at = (at + 1) & (size - 1))
    {
      const Vector<3>& other = surface.points[table[at]];
      if (other[0] == x[0] && other[1] == x[1] && other[2] == x[2])
        return table[at];
    }
    table[at] = static_cast<int>(surface.points.size());
    surface.points.push_back(x);
    return table[at];
  };
  for (const auto& t : mesh.triangles)
  {
    std::array<int, 3> item;
    for (int i = 0; i < 3; ++i)
      item[i] = numberOf(mesh.points[t[i]]);
    surface.items.push_back(item);
  }
  return surface;
}

MergedPoints mergeShortEdges(Simplices<3>& surface, double distance)
{
  Groups groups(surface.points.size());
  MergedPoints merged;
  for (const auto& v : surface.items)
    for (int i = 0; i < 3; ++i)
    {
      const int a = v[i], b = v[(i + 1) % 3];
      if (a != b && norm(surface.points[a] - surface.points[b]) <= distance)
        unite(surface, a, b, groups, merged);
    }
  if (merged.pairs > 0)
    rename(surface, groups);
  return merged;
}

MergedPoints mergeNearPoints(Simplices<3>& surface, const std::vector<int>& points, double distance)
{
  std::vector<int> inOrder = points;
  const auto& x = surface.points;
  std::sort(inOrder.begin(), inOrder.end(),
            [&](int a, int b) { return x[a][0] != x[b][0] ? x[a][0] < x[b][0] : a < b; });
  Groups groups(surface.points.size());
  MergedPoints merged;
  for (std::size_t k = 0; k < inOrder.size(); ++k)
    for (std::size_t m = k + 1; m < inOrder.size() && x[inOrder[m]][0] - x[inOrder[k]][0] <= distance; ++m)
      if (norm(x[inOrder[m]] - x[inOrder[k]]) <= distance)
        unite(surface, inOrder[k], inOrder[m], groups, merged);
  if (merged.pairs > 0)
    rename(surface, groups);
  return merged;
}

int dropCollapsed(Simplices<3>& surface)
{
  const auto before = surface.items.size();
  surface.items.erase(std::remove_if(surface.items.begin(), surface.items.end(),
                                     [](const auto& v)
                                     { return v[0] == v[1] || v[1] == v[2] || v[2] == v[0]; }),
                      surface.items.end());
  return static_cast<int>(before - surface.items.size());
}

} // namespace Rhegma::Geometry
