#include "surface/SurfaceMesh.hpp"

#include "geometry/Cross.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

namespace Rhegma::surface
{

namespace
{

using Triangle = std::array<int, 3>;

std::string number(std::size_t t) { return std::to_string(t + 1); }

std::string asText(const Vector<3>& x)
{
  return std::to_string(x[0]) + ", " + std::to_string(x[1]) + ", " + std::to_string(x[2]) + " m";
}

void refuseDegenerate(const SurfaceMesh& mesh)
{
  constexpr double flat = 1e-6; // height of a triangle in its longest edges
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const Vector<3>&a = mesh.points[mesh.triangles[t][0]], &b = mesh.points[mesh.triangles[t][1]],
          &c = mesh.points[mesh.triangles[t][2]];
    const double longest = std::max({norm(b - a), norm(c - b), norm(a - c)});
    if (!(norm(cross(b - a, c - a)) > flat * longest * longest))
      throw std::invalid_argument("triangle " + number(t) + " (counted from 1), at " + asText(a) +
                                  ", has no area");
  }
}

std::map<Edge, std::vector<int>> trianglesAtEdges(const SurfaceMesh& mesh)
{
  std::map<Edge, std::vector<int>> triangles;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i)
    {
      std::vector<int>& at = triangles[edgeOf(mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3])];
      at.push_back(static_cast<int>(t));
      if (at.size() > 2)
        throw std::invalid_argument("three triangles meet at the edge at " +
                                    asText(mesh.points[mesh.triangles[t][i]]) +
                                    "; a crack is one sheet, so write its branches as cracks of their own");
    }
  return triangles;
}

/// Whether a triangle goes from corner a to corner b.
bool runsAlong(const Triangle& v, int a, int b)
{
  return (v[0] == a && v[1] == b) || (v[1] == a && v[2] == b) || (v[2] == a && v[0] == b);
}

} // namespace

void weld(SurfaceMesh& mesh, double tolerance)
{
  // Points are binned by cells of the size of the tolerance; near points may lie in neighbouring cells.
  using Cell = std::array<long long, 3>;
  std::map<Cell, std::vector<int>> cells;
  std::vector<Vector<3>> points;
  std::vector<int> number(mesh.points.size());
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    const Vector<3>& x = mesh.points[p];
    Cell at;
    for (int d = 0; d < 3; ++d)
      at[d] = static_cast<long long>(std::floor(x[d] / tolerance));
    int found = -1;
    for (int k = 0; k < 27 && found < 0; ++k)
    {
      const auto near = cells.find({at[0] + k % 3 - 1, at[1] + k / 3 % 3 - 1, at[2] + k / 9 - 1});
      if (near == cells.end())
        continue;
      for (const int q : near->second)
        if (norm(points[q] - x) < tolerance)
          found = q;
    }
    if (found < 0)
    {
      found = static_cast<int>(points.size());
      points.push_back(x);
      cells[at].push_back(found);
    }
    number[p] = found;
  }
  mesh.points = points;
  for (Triangle& t : mesh.triangles)
    for (int& v : t)
      v = number[v];
}

void orient(SurfaceMesh& mesh)
{
  refuseDegenerate(mesh);
  const auto withEdge = trianglesAtEdges(mesh);
  std::vector<bool> done(mesh.triangles.size(), false);
  std::vector<int> next{0};
  done[0] = true;
  std::size_t count = 1;
  while (!next.empty())
  {
    const int t = next.back();
    next.pop_back();
    for (int i = 0; i < 3; ++i)
    {
      const int a = mesh.triangles[t][i], b = mesh.triangles[t][(i + 1) % 3];
      for (const int u : withEdge.at(edgeOf(a, b)))
      {
        if (u == t || (done[u] && !runsAlong(mesh.triangles[u], a, b)))
          continue;
        if (done[u])
          throw std::invalid_argument("the surface has only one side, as a Moebius strip; a crack has two");
        if (runsAlong(mesh.triangles[u], a, b))
          std::swap(mesh.triangles[u][1], mesh.triangles[u][2]);
        done[u] = true;
        ++count;
        next.push_back(u);
      }
    }
  }
  if (count < mesh.triangles.size())
    throw std::invalid_argument("the surface consists of several unconnected pieces; write each piece as a "
                                "crack of its own, or make their points meet");
  if (std::none_of(withEdge.begin(), withEdge.end(), [](const auto& at) { return at.second.size() == 1; }))
    throw std::invalid_argument("the surface is closed and so has no front; give a sheet with a border");
}

} // namespace Rhegma::surface
