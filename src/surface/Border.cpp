#include "surface/Border.hpp"

#include "geometry/Cross.hpp"
#include "surface/Triangulation.hpp"

#include <map>
#include <set>
#include <vector>

namespace Rhegma::surface
{

namespace
{

constexpr double some = 0.1; ///< material ahead of an edge, which may be cut along a curved surface [cells]

/// Whether a border edge is one of a front that meets a surface at an angle: straight ahead of it the body
/// ends, but at one end of the edge only, and from the other there is material for a cell, straight ahead or
/// by up to 45 degrees away from the surface. \param out across the edge, of any length
bool meetsSurfaceAtAnAngle(const Region<3>& bodies, const Vector<3>& a, const Vector<3>& b,
                           const Vector<3>& out, double cell)
{
  constexpr double nearEnd = 0.1, just = 0.25; // of the edge; of a cell
  const Vector<3> along = b - a, ahead = (1.0 / norm(out)) * out;
  for (const bool back : {false, true})
  {
    const Vector<3> in = back ? a + nearEnd * along : b - nearEnd * along,
                    at = back ? b - nearEnd * along : a + nearEnd * along;
    const Vector<3> aside = ((back ? -1.0 : 1.0) / norm(along)) * along;
    if (!bodies(at + just * cell * ahead) && bodies(in + just * cell * ahead) &&
        (extendsBeyond(bodies, in, ahead, cell) || extendsBeyond(bodies, in, ahead + aside, cell)))
      return true;
  }
  return false;
}

/// An edge with too little material ahead of it.
struct ThinEdge
{
  std::size_t triangle;
  int side;
  int ends[2]; ///< vertices
  double length;
  Vector<3> middle;
};

/// Edges of a chain without gaps, of some edges. \param first its number, of those that are not yet used
std::vector<std::size_t> chainFrom(std::size_t first, const std::vector<ThinEdge>& edges,
                                   const std::multimap<int, std::size_t>& at, std::vector<char>& used)
{
  std::vector<std::size_t> chain{first};
  used[first] = 1;
  for (std::size_t k = 0; k < chain.size(); ++k)
    for (const int vertex : edges[chain[k]].ends)
      for (auto [here, end] = at.equal_range(vertex); here != end; ++here)
        if (!used[here->second])
        {
          used[here->second] = 1;
          chain.push_back(here->second);
        }
  return chain;
}

/// Makes one front of two that a chain of less than a cell parts; adds longer chains to what is broken.
BrokenLigament joinFronts(CrackMesh<3>& mesh, const std::vector<ThinEdge>& edges,
                          const std::set<int>& endsOfFronts, double cell)
{
  std::multimap<int, std::size_t> at;
  for (std::size_t e = 0; e < edges.size(); ++e)
    for (const int vertex : edges[e].ends)
      at.emplace(vertex, e);
  BrokenLigament broken;
  double longest = 0.0;
  std::vector<char> used(edges.size(), 0);
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    if (used[e])
      continue;
    const std::vector<std::size_t> chain = chainFrom(e, edges, at, used);
    double length = 0.0;
    int joined = 0; // ends of the chain at which there is a front
    for (const std::size_t k : chain)
    {
      length += edges[k].length;
      for (const int vertex : edges[k].ends)
        joined += at.count(vertex) == 1 && endsOfFronts.count(vertex) > 0 ? 1 : 0;
    }
    const bool isShort = length < (1.0 - 1e-6) * cell;
    for (const std::size_t k : chain)
    {
      if (isShort && joined == 2)
        mesh.beyond[edges[k].triangle][edges[k].side] = facet::front;
      if (!isShort && edges[k].length > longest)
      {
        longest = edges[k].length;
        broken.middle = edges[k].middle;
      }
    }
    broken.length += isShort ? 0.0 : length;
  }
  return broken;
}

} // namespace

BrokenLigament markBorder(CrackMesh<3>& mesh, const KindOfBorder& kindOf, const Region<3>& bodies,
                          double cell)
{
  std::vector<ThinEdge> thin;
  std::set<int> endsOfFronts;
  mesh.beyond = findNeighbours(mesh.simplices);
  for (std::size_t t = 0; t < mesh.simplices.size(); ++t)
    for (int i = 0; i < 3; ++i)
    {
      if (mesh.beyond[t][i] >= 0)
        continue;
      const int first = mesh.simplices[t][(i + 1) % 3], second = mesh.simplices[t][(i + 2) % 3];
      const Vector<3>&a = mesh.vertices[first], &b = mesh.vertices[second],
            &c = mesh.vertices[mesh.simplices[t][i]];
      const Vector<3> middle = 0.5 * (a + b), out = cross(b - a, cross(b - a, c - a));
      const BorderKind kind = kindOf(middle);
      const bool front =
          kind == BorderKind::Front ||
          (kind == BorderKind::FrontIfMaterialAhead &&
           (extendsBeyond(bodies, middle, out, cell) || meetsSurfaceAtAnAngle(bodies, a, b, out, cell)));
      mesh.beyond[t][i] = front ? facet::front : facet::surfaceBreaking;
      if (front)
        endsOfFronts.insert({first, second});
      else if (kind != BorderKind::SurfaceBreaking && bodies(middle + (some * cell / norm(out)) * out))
        thin.push_back({t, i, {first, second}, norm(b - a), middle});
    }
  return joinFronts(mesh, thin, endsOfFronts, cell);
}

} // namespace Rhegma::surface
