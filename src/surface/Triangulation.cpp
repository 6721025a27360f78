#include "surface/Triangulation.hpp"

#include "surface/CutTriangles.hpp"
#include "surface/EdgeFlips.hpp"
#include "surface/NearestOnSimplex.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace Rhegma::surface
{

namespace
{

using Points = std::vector<Vector<2>>;
using Triangle = std::array<int, 3>;

Points splitEdges(const Points& outline, double longest)
{
  Points split;
  for (std::size_t k = 0; k < outline.size(); ++k)
  {
    const Vector<2> along = outline[(k + 1) % outline.size()] - outline[k];
    const int pieces = std::max(1, static_cast<int>(std::ceil(norm(along) / longest - 1e-9)));
    for (int i = 0; i < pieces; ++i)
      split.push_back(outline[k] + (double(i) / pieces) * along);
  }
  return split;
}

bool isInTriangle(const Vector<2>& x, const Vector<2>& a, const Vector<2>& b, const Vector<2>& c,
                  double margin)
{
  return doubleArea(a, b, x) > margin && doubleArea(b, c, x) > margin && doubleArea(c, a, x) > margin;
}

/// Cuts off ears, those with the shortest cut first.
std::vector<Triangle> cutEars(const Points& points)
{
  std::vector<int> rest(points.size());
  for (std::size_t k = 0; k < rest.size(); ++k)
    rest[k] = static_cast<int>(k);
  double extent = 0.0;
  for (const Vector<2>& x : points)
    extent = std::max(extent, norm(x - points.front()));
  const double tiny = 1e-12 * extent * extent;
  std::vector<Triangle> triangles;
  while (rest.size() > 3)
  {
    const int n = static_cast<int>(rest.size());
    int ear = -1;
    double shortest = 1e300;
    for (int k = 0; k < n; ++k)
    {
      const int i = rest[(k + n - 1) % n], j = rest[k], l = rest[(k + 1) % n];
      const double cut = norm(points[l] - points[i]);
      if (cut >= shortest || doubleArea(points[i], points[j], points[l]) <= tiny)
        continue;
      bool empty = true;
      for (const int o : rest)
        empty = empty && (o == i || o == j || o == l ||
                          !isInTriangle(points[o], points[i], points[j], points[l], -tiny));
      if (!empty)
        continue;
      ear = k;
      shortest = cut;
    }
    if (ear < 0) // only round-off is left
      return triangles;
    triangles.push_back({rest[(ear + n - 1) % n], rest[ear], rest[(ear + 1) % n]});
    rest.erase(rest.begin() + ear);
  }
  triangles.push_back({rest[0], rest[1], rest[2]});
  return triangles;
}

double distanceToBorder(const Vector<2>& x, const Points& border)
{
  double nearest = 1e300;
  for (std::size_t k = 0; k < border.size(); ++k)
    nearest = std::min(nearest, distanceToSegment(x, border[k], border[(k + 1) % border.size()]));
  return nearest;
}

/// Triangles that are split by points within them. Split triangles form a tree, in which the triangle of a
/// point is found without checking all.
class SplitTriangles
{
public:
  explicit SplitTriangles(Triangulation& mesh) : mesh_(mesh), whole_(static_cast<int>(mesh.triangles.size()))
  {
    nodes_.reserve(mesh.triangles.size());
    for (int t = 0; t < whole_; ++t)
      nodes_.push_back({mesh.triangles[t], t, -1});
  }

  /// Splits the triangle that a point lies in; a point on an edge or outside is ignored.
  void insert(const Vector<2>& x, double margin)
  {
    const int found = find(x, margin);
    if (found < 0)
      return;
    const int p = static_cast<int>(mesh_.points.size()), next = static_cast<int>(mesh_.triangles.size());
    mesh_.points.push_back(x);
    const Triangle whole = nodes_[found].corners;
    const int t = nodes_[found].triangle;
    mesh_.triangles[t] = {whole[0], whole[1], p};
    mesh_.triangles.push_back({whole[1], whole[2], p});
    mesh_.triangles.push_back({whole[2], whole[0], p});
    nodes_[found].firstPart = static_cast<int>(nodes_.size());
    for (const int part : {t, next, next + 1})
      nodes_.push_back({mesh_.triangles[part], part, -1});
  }

private:
  struct Node
  {
    Triangle corners;
    int triangle;  ///< its number while it is not split
    int firstPart; ///< first of three consecutive parts; -1: not split
  };

  bool holds(const Node& node, const Vector<2>& x, double margin) const
  {
    const Points& at = mesh_.points;
    return isInTriangle(x, at[node.corners[0]], at[node.corners[1]], at[node.corners[2]], margin);
  }

  /// The unsplit triangle that contains a point by a margin, or -1.
  int find(const Vector<2>& x, double margin)
  {
    for (int root = 0; root < whole_; ++root)
    {
      open_.assign(1, root);
      while (!open_.empty())
      {
        const int n = open_.back();
        open_.pop_back();
        const int first = nodes_[n].firstPart;
        if (first < 0 && holds(nodes_[n], x, margin))
          return n;
        // A point in a part may lie on the edge of the split triangle, to round-off.
        if (first >= 0 && holds(nodes_[n], x, -margin))
          open_.insert(open_.end(), {first, first + 1, first + 2});
      }
    }
    return -1;
  }

  Triangulation& mesh_;
  int whole_; ///< number of triangles at the start
  std::vector<Node> nodes_;
  std::vector<int> open_;
};

/// Adds points of a hexagonal lattice away from the border.
void fillInside(Triangulation& mesh, const Points& border, double spacing)
{
  Vector<2> lower{1e300, 1e300}, upper{-1e300, -1e300};
  for (const Vector<2>& x : border)
    for (int d = 0; d < 2; ++d)
    {
      lower[d] = std::min(lower[d], x[d]);
      upper[d] = std::max(upper[d], x[d]);
    }
  const double rise = spacing * std::sqrt(0.75);
  const Vector<2> middle = 0.5 * (lower + upper);
  const int columns = static_cast<int>((upper[0] - lower[0]) / spacing) / 2 + 1;
  const int rows = static_cast<int>((upper[1] - lower[1]) / rise) / 2 + 1;
  // Shifted from the middle by odd fractions, off the diagonals of regular polygons.
  const Vector<2> start{middle[0] + 0.0137 * spacing, middle[1] + 0.0071 * spacing};
  SplitTriangles triangles(mesh);
  for (int j = -rows; j <= rows; ++j)
    for (int i = -columns; i <= columns; ++i)
    {
      const Vector<2> x{start[0] + spacing * (i + 0.5 * std::abs(j % 2)), start[1] + rise * j};
      if (distanceToBorder(x, border) > 0.6 * spacing)
        triangles.insert(x, 1e-9 * spacing * spacing);
    }
}

bool covers(const Triangulation& mesh, const Vector<2>& x)
{
  return std::any_of(mesh.triangles.begin(), mesh.triangles.end(),
                     [&](const Triangle& t)
                     {
                       const Vector<2>&a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
                       return isInTriangle(x, a, b, c, -1e-9 * doubleArea(a, b, c));
                     });
}

/// Cuts are straight at corners of the region: adds a triangle to each border edge beyond which the region
/// continues.
void fillCorners(Triangulation& cut, const Triangulation& whole, const Region<2>& region)
{
  constexpr double worthwhile = 0.02; // height of the triangle, in edges
  const auto neighbours = findNeighbours(cut.triangles);
  const auto isThere = [&](const Vector<2>& x) { return region(x) && covers(whole, x); };
  for (std::size_t t = 0; t < neighbours.size(); ++t)
    for (int i = 0; i < 3; ++i)
    {
      if (neighbours[t][i] >= 0)
        continue;
      const int a = cut.triangles[t][(i + 1) % 3], b = cut.triangles[t][(i + 2) % 3];
      const Vector<2> along = cut.points[b] - cut.points[a], out{along[1], -along[0]};
      Vector<2> low = 0.5 * (cut.points[a] + cut.points[b]), high = low + out;
      const Vector<2> middle = low;
      if (!isThere(low + worthwhile * out) || isThere(high))
        continue;
      for (int halving = 0; halving < 10; ++halving)
      {
        const Vector<2> between = 0.5 * (low + high);
        (isThere(between) ? low : high) = between;
      }
      if (norm(low - middle) < worthwhile * norm(along))
        continue;
      cut.triangles.push_back({a, static_cast<int>(cut.points.size()), b});
      cut.points.push_back(low);
    }
}

} // namespace

double doubleArea(const Vector<2>& a, const Vector<2>& b, const Vector<2>& c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
}

std::vector<std::array<int, 3>> findNeighbours(const std::vector<std::array<int, 3>>& triangles)
{
  std::map<std::pair<int, int>, int> withEdge;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int i = 0; i < 3; ++i)
      withEdge[{triangles[t][(i + 1) % 3], triangles[t][(i + 2) % 3]}] = static_cast<int>(t);
  std::vector<std::array<int, 3>> neighbours(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int i = 0; i < 3; ++i)
    {
      const auto other = withEdge.find({triangles[t][(i + 2) % 3], triangles[t][(i + 1) % 3]});
      neighbours[t][i] = other == withEdge.end() ? -1 : other->second;
    }
  return neighbours;
}

Triangulation triangulate(const std::vector<Vector<2>>& outline, double spacing)
{
  const Points border = splitEdges(outline, spacing);
  Triangulation mesh;
  mesh.points = border;
  mesh.triangles = cutEars(border);
  fillInside(mesh, border, spacing);
  // Lawson's flips come to an end; the bound is for round-off that flips to and fro.
  const std::size_t most = 100 + mesh.triangles.size();
  EdgeFlips flips(mesh, spacing);
  for (std::size_t round = 0; round < most && flips.round(); ++round)
  {
  }
  return mesh;
}

Triangulation cutToRegion(const Triangulation& whole, const Region<2>& region)
{
  Triangulation cut = whole;
  cutTriangles<2>(cut.points, cut.triangles, region);
  for (int round = 0; round < 3; ++round)
    fillCorners(cut, whole, region);
  return cut;
}

} // namespace Rhegma::surface
