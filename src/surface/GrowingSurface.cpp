#include "surface/GrowingSurface.hpp"

#include "geometry/Cross.hpp"
#include "surface/Triangulation.hpp"

#include <algorithm>
#include <set>

namespace Rhegma::surface
{

namespace
{

/// Cosine of ten degrees.
constexpr double straight = 0.985;

using Triangle = std::array<int, 3>;

bool has(const Triangle& t, int v) { return t[0] == v || t[1] == v || t[2] == v; }

} // namespace

void GrowingSurface::prepare()
{
  stars_.assign(vertices.size(), {});
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (const int v : triangles[t])
      stars_[v].push_back(static_cast<int>(t));
}

double GrowingSurface::areaOf(const Triangle& t) const
{
  return 0.5 * norm(cross(vertices[t[1]] - vertices[t[0]], vertices[t[2]] - vertices[t[0]]));
}

double GrowingSurface::areaAround(int v) const
{
  double sum = 0.0;
  for (const int t : stars_[v])
    sum += areaOf(triangles[t]);
  return sum;
}

void GrowingSurface::addTriangle(const Triangle& t)
{
  for (const int v : t)
    stars_[v].push_back(static_cast<int>(triangles.size()));
  triangles.push_back(t);
}

int GrowingSurface::addVertex(const Vector<3>& x)
{
  vertices.push_back(x);
  faces.push_back({x, x});
  stars_.emplace_back();
  return static_cast<int>(vertices.size()) - 1;
}

std::vector<int> GrowingSurface::trianglesAt(int a, int b) const
{
  std::vector<int> found;
  for (const int t : stars_[a])
    if (has(triangles[t], b))
      found.push_back(t);
  return found;
}

double GrowingSurface::pieceAt(const FrontLines<3>& lines, std::size_t k) const
{
  return norm(vertices[lines[nextPoint(lines, k)].vertex] - vertices[lines[k].vertex]);
}

double GrowingSurface::advance(FrontLines<3>& lines, std::size_t k, const Vector<3>& x, double row)
{
  FrontPoint<3>& point = lines[k];
  const int v = point.vertex, last = previousPoint(lines, k);
  const int u = last >= 0 ? lines[last].vertex : -1,
            w = point.joined ? lines[nextPoint(lines, k)].vertex : -1;
  const Vector<3> path = x - vertices[v];
  // Distances of the vertices behind it, and rotations of the triangles that would stretch.
  bool stretches = dot(path, point.direction) > straight * norm(path);
  double nearest = 1e300;
  for (const int t : stars_[v])
    for (const int other : triangles[t])
      if (other != v && other != u && other != w)
        nearest = std::min(nearest, norm(x - vertices[other]));
  stretches = stretches && nearest <= row;
  if (stretches)
  {
    const double area = areaAround(v);
    vertices[v] = x;
    faces[v] = {x, x};
    return areaAround(v) - area;
  }
  const int added = addVertex(x);
  double area = 0.0;
  for (const auto& [a, b] : {std::make_pair(u, v), std::make_pair(v, w)})
    if (a >= 0 && b >= 0)
    {
      addTriangle({b, a, added});
      area += areaOf(triangles.back());
    }
  point.vertex = added;
  return area;
}

double GrowingSurface::shift(int v, const Vector<3>& by)
{
  const double area = areaAround(v);
  vertices[v] = vertices[v] + by;
  faces[v] = {vertices[v], vertices[v]};
  return areaAround(v) - area;
}

void GrowingSurface::split(FrontLines<3>& lines, std::size_t k, int name)
{
  const std::size_t to = nextPoint(lines, k);
  const int a = lines[k].vertex, b = lines[to].vertex;
  const std::vector<int> at = trianglesAt(a, b);
  if (at.size() != 1)
    return;
  const int m = addVertex(0.5 * (vertices[a] + vertices[b]));
  Triangle other = triangles[at[0]];
  for (int& v : triangles[at[0]])
    v = v == b ? m : v;
  stars_[b].erase(std::find(stars_[b].begin(), stars_[b].end(), at[0]));
  stars_[m].push_back(at[0]);
  for (int& v : other)
    v = v == a ? m : v;
  addTriangle(other);
  // It continues as the neighbour that advances.
  FrontPoint<3> point = lines[lines[k].stopped || lines[k].landed ? to : k];
  point.from = point.name;
  point.vertex = m;
  point.name = name;
  point.toughness = meanToughness(lines[k], lines[to]);
  point.landed = false;
  point.joined = true;
  lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(k) + 1, point);
}

bool GrowingSurface::mayMerge(int a, int b, const Vector<3>& x, int shared) const
{
  std::set<int> around[2];
  for (int side = 0; side < 2; ++side)
    for (const int t : stars_[side == 0 ? a : b])
      for (const int v : triangles[t])
        if (v != a && v != b)
          around[side].insert(v);
  int common = 0;
  for (const int v : around[0])
    common += static_cast<int>(around[1].count(v));
  if (common != 1)
    return false;
  const auto areaVector = [&](const Triangle& t, bool moved)
  {
    Vector<3> corner[3];
    for (int i = 0; i < 3; ++i)
      corner[i] = moved && (t[i] == a || t[i] == b) ? x : vertices[t[i]];
    return cross(corner[1] - corner[0], corner[2] - corner[0]);
  };
  for (const int v : {a, b})
    for (const int t : stars_[v])
      if (t != shared && !(dot(areaVector(triangles[t], false), areaVector(triangles[t], true)) > 0.0))
        return false;
  return true;
}

bool GrowingSurface::collapse(FrontLines<3>& lines, std::size_t k, double& added)
{
  const std::size_t to = nextPoint(lines, k);
  const int a = lines[k].vertex, b = lines[to].vertex;
  const std::vector<int> shared = trianglesAt(a, b);
  if (shared.size() != 1 || lines.size() < 5 || lines[k].landed || lines[to].landed)
    return false;
  // An end of a line does not move.
  const bool first = previousPoint(lines, k) < 0, last = !lines[to].joined;
  if (first && last)
    return false;
  const Vector<3> x = first ? vertices[a] : last ? vertices[b] : 0.5 * (vertices[a] + vertices[b]);
  if (!mayMerge(a, b, x, shared[0]))
    return false;
  double before = 0.0;
  for (const int v : {a, b})
    for (const int t : stars_[v])
      if (t != shared[0])
        before += areaOf(triangles[t]);
  before += areaOf(triangles[shared[0]]);
  for (const int v : triangles[shared[0]])
    stars_[v].erase(std::find(stars_[v].begin(), stars_[v].end(), shared[0]));
  triangles[shared[0]] = {-1, -1, -1};
  for (const int t : stars_[b])
  {
    for (int& v : triangles[t])
      v = v == b ? a : v;
    stars_[a].push_back(t);
  }
  stars_[b].clear();
  vertices[a] = x;
  faces[a] = {x, x};
  added = areaAround(a) - before;
  FrontPoint<3>& kept = lines[k];
  kept.joined = lines[to].joined;
  if (last)
    kept.name = lines[to].name;
  lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(to));
  return true;
}

void GrowingSurface::tidy(const std::vector<FrontLines<3>*>& lines)
{
  std::vector<int> number(vertices.size(), -1);
  int kept = 0;
  for (std::size_t v = 0; v < vertices.size(); ++v)
    if (!stars_[v].empty())
    {
      number[v] = kept;
      vertices[kept] = vertices[v];
      faces[kept] = faces[v];
      ++kept;
    }
  vertices.resize(kept);
  faces.resize(kept);
  triangles.erase(
      std::remove_if(triangles.begin(), triangles.end(), [](const Triangle& t) { return t[0] < 0; }),
      triangles.end());
  for (Triangle& t : triangles)
    for (int& v : t)
      v = number[v];
  for (FrontLines<3>* line : lines)
    for (FrontPoint<3>& point : *line)
      point.vertex = number[point.vertex];
  prepare();
}

CrackMesh<3> GrowingSurface::mesh(const std::vector<const FrontLines<3>*>& lines) const
{
  CrackMesh<3> mesh;
  mesh.vertices = vertices;
  mesh.simplices = triangles;
  mesh.beyond = findNeighbours(triangles);
  std::set<std::pair<int, int>> pieces;
  for (const FrontLines<3>* line : lines)
    for (std::size_t k = 0; k < line->size(); ++k)
      if ((*line)[k].joined)
        pieces.insert({(*line)[k].vertex, (*line)[nextPoint(*line, k)].vertex});
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int i = 0; i < 3; ++i)
      if (mesh.beyond[t][i] < 0)
        mesh.beyond[t][i] = pieces.count({triangles[t][(i + 1) % 3], triangles[t][(i + 2) % 3]}) != 0
                                ? facet::front
                                : facet::surfaceBreaking;
  return mesh;
}

} // namespace Rhegma::surface
