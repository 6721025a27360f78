#include "geometry/Cross.hpp"
#include "surface/SurfaceMesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>
#include <set>
#include <utility>

namespace Rhegma::surface
{

namespace
{

using Triangle = std::array<int, 3>;

constexpr double longest = 1.4, shortest = 0.5; // edges
constexpr double turned = 0.966;                // cosine of 15 degrees

/// Triangles whose edges change; removed ones have a corner -1.
class Remesher
{
public:
  Remesher(SurfaceMesh& mesh, double edge) : mesh_(mesh), edge_(edge), star_(mesh.points.size())
  {
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      for (const int v : mesh_.triangles[t])
        star_[v].insert(static_cast<int>(t));
  }

  /// The longest edge is split first: it is the longest of its triangles too (Rivara, Int. J. Numer. Methods
  /// Eng. 20 (1984) 745), so angles stay away from zero.
  void split()
  {
    std::priority_queue<std::pair<double, Edge>> edges;
    const auto addEdge = [&](int a, int b)
    {
      const double length = norm(mesh_.points[a] - mesh_.points[b]);
      if (length > longest * edge_)
        edges.push({length, edgeOf(a, b)});
    };
    for (const Triangle& t : mesh_.triangles)
      for (int i = 0; i < 3 && t[0] >= 0; ++i)
        if (t[i] < t[(i + 1) % 3] || trianglesAt(t[i], t[(i + 1) % 3]).size() == 1)
          addEdge(t[i], t[(i + 1) % 3]);
    while (!edges.empty())
    {
      const auto [a, b] = edges.top().second;
      edges.pop();
      const std::vector<int> at = trianglesAt(a, b);
      if (at.empty())
        continue;
      const int m = static_cast<int>(mesh_.points.size());
      mesh_.points.push_back(0.5 * (mesh_.points[a] + mesh_.points[b]));
      star_.emplace_back();
      addEdge(a, m);
      addEdge(b, m);
      for (const int t : at)
      {
        Triangle other = mesh_.triangles[t];
        int third = -1;
        for (const int v : other)
          third = v != a && v != b ? v : third;
        replace(t, b, m);
        for (int& v : other)
          v = v == a ? m : v;
        add(other);
        addEdge(third, m);
      }
    }
  }

  /// Collapses short edges, the shortest of a round first.
  void collapse()
  {
    for (int round = 0; round < 10; ++round)
    {
      std::vector<std::pair<double, Edge>> edges;
      for (const Triangle& t : mesh_.triangles)
        for (int i = 0; i < 3 && t[0] >= 0; ++i)
        {
          const double length = norm(mesh_.points[t[i]] - mesh_.points[t[(i + 1) % 3]]);
          if (length < shortest * edge_)
            edges.push_back({length, edgeOf(t[i], t[(i + 1) % 3])});
        }
      std::sort(edges.begin(), edges.end());
      bool any = false;
      for (const auto& [length, edge] : edges)
        any = (mayCollapse(edge.first, edge.second) && collapseInto(edge.first, edge.second)) ||
              (mayCollapse(edge.second, edge.first) && collapseInto(edge.second, edge.first)) || any;
      if (!any)
        return;
    }
  }

  /// Removes unused points and triangles.
  void tidy()
  {
    std::vector<int> number(mesh_.points.size(), -1);
    SurfaceMesh tidied;
    for (Triangle t : mesh_.triangles)
    {
      if (t[0] < 0)
        continue;
      for (int& v : t)
      {
        if (number[v] < 0)
        {
          number[v] = static_cast<int>(tidied.points.size());
          tidied.points.push_back(mesh_.points[v]);
        }
        v = number[v];
      }
      tidied.triangles.push_back(t);
    }
    mesh_ = tidied;
  }

private:
  std::vector<int> trianglesAt(int a, int b) const
  {
    std::vector<int> both;
    std::set_intersection(star_[a].begin(), star_[a].end(), star_[b].begin(), star_[b].end(),
                          std::back_inserter(both));
    return both;
  }

  std::set<int> around(int v) const
  {
    std::set<int> points;
    for (const int t : star_[v])
      points.insert(mesh_.triangles[t].begin(), mesh_.triangles[t].end());
    points.erase(v);
    return points;
  }

  std::vector<int> borderNeighbours(int v) const
  {
    std::vector<int> found;
    for (const int w : around(v))
      if (trianglesAt(v, w).size() == 1)
        found.push_back(w);
    return found;
  }

  void add(const Triangle& triangle)
  {
    for (const int v : triangle)
      star_[v].insert(static_cast<int>(mesh_.triangles.size()));
    mesh_.triangles.push_back(triangle);
  }

  void replace(int t, int from, int to)
  {
    for (int& v : mesh_.triangles[t])
      v = v == from ? to : v;
    star_[from].erase(t);
    star_[to].insert(t);
  }

  Vector<3> areaOf(const Triangle& t) const
  {
    return cross(mesh_.points[t[1]] - mesh_.points[t[0]], mesh_.points[t[2]] - mesh_.points[t[0]]);
  }

  /// Whether point b may move onto point a.
  bool mayCollapse(int a, int b) const
  {
    const std::vector<int> shared = trianglesAt(a, b);
    if (shared.empty())
      return false;
    // The two may have no other common neighbours than the third corners of their triangles.
    const std::set<int> one = around(a), other = around(b);
    std::vector<int> common;
    std::set_intersection(one.begin(), one.end(), other.begin(), other.end(), std::back_inserter(common));
    if (common.size() != shared.size())
      return false;
    const std::vector<int> border = borderNeighbours(b);
    if (!border.empty())
    {
      if (shared.size() != 1 || border.size() != 2)
        return false;
      const Vector<3> in = mesh_.points[b] - mesh_.points[border[0]],
                      out = mesh_.points[border[1]] - mesh_.points[b];
      if (dot(in, out) < turned * norm(in) * norm(out))
        return false;
    }
    for (const int t : star_[b])
    {
      Triangle moved = mesh_.triangles[t];
      if (std::find(shared.begin(), shared.end(), t) != shared.end())
        continue;
      for (int& v : moved)
        v = v == b ? a : v;
      for (const int v : moved)
        if (norm(mesh_.points[v] - mesh_.points[a]) > longest * edge_)
          return false;
      const Vector<3> before = areaOf(mesh_.triangles[t]), after = areaOf(moved);
      if (dot(before, after) <= turned * norm(before) * norm(after))
        return false;
    }
    return true;
  }

  bool collapseInto(int a, int b)
  {
    for (const int t : trianglesAt(a, b))
    {
      for (const int v : mesh_.triangles[t])
        star_[v].erase(t);
      mesh_.triangles[t] = {-1, -1, -1};
    }
    const std::set<int> rest = star_[b];
    for (const int t : rest)
      replace(t, b, a);
    return true;
  }

  SurfaceMesh& mesh_;
  double edge_;
  std::vector<std::set<int>> star_; ///< triangles at each point
};

} // namespace

void remesh(SurfaceMesh& mesh, double edge)
{
  Remesher remesher(mesh, edge);
  remesher.collapse();
  remesher.split();
  remesher.collapse();
  remesher.tidy();
}

} // namespace Rhegma::surface
