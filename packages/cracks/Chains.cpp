#include "cracks/Chains.hpp"

#include "cracks/Layout.hpp"
#include "surface/Polyline.hpp"

namespace Rhegma::cracks
{

namespace
{

int beyondEnd(const Chain& chain, int end)
{
  return chain.front[end] ? facet::front : chain.joined[end] ? facet::joined : facet::surfaceBreaking;
}

surface::CrackMesh<2> meshOf(const Chain& chain)
{
  std::vector<Vector<2>> points;
  points.reserve(chain.links.size());
  for (const Link& link : chain.links)
    points.push_back(link.vertex);
  return surface::polylineMesh(points, {beyondEnd(chain, 0), beyondEnd(chain, 1)});
}

} // namespace

std::vector<Chain> readChains(const CrackSet<2>& set)
{
  const auto vertex = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, set.vertex);
  const auto face = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, set.face);
  const auto neighbour = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, set.neighbour);
  std::vector<Chain> chains;
  for (const Crack<2>& crack : set.cracks)
  {
    Chain chain;
    for (int v = crack.firstVertex; v < crack.firstVertex + crack.numVertices; ++v)
    {
      Link link;
      for (int d = 0; d < 2; ++d)
      {
        link.vertex[d] = vertex(v, d);
        link.face[0][d] = face(v, 0, d);
        link.face[1][d] = face(v, 1, d);
      }
      chain.links.push_back(link);
    }
    const int beyond[2] = {neighbour(crack.firstSimplex, 1),
                           neighbour(crack.firstSimplex + crack.numSimplices - 1, 0)};
    for (int end = 0; end < 2; ++end)
    {
      chain.front[end] = beyond[end] == facet::front;
      chain.joined[end] = beyond[end] == facet::joined;
    }
    chains.push_back(chain);
  }
  return chains;
}

void writeChains(CrackSet<2>& set, const std::vector<Chain>& chains, double spacing)
{
  std::vector<surface::CrackMesh<2>> meshes;
  meshes.reserve(chains.size());
  for (const Chain& chain : chains)
    meshes.push_back(meshOf(chain));
  layOut(set, meshes, spacing);
  const auto face = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, set.face);
  for (std::size_t c = 0; c < chains.size(); ++c)
    for (std::size_t v = 0; v < chains[c].links.size(); ++v)
      for (int side = 0; side < 2; ++side)
        for (int d = 0; d < 2; ++d)
          face(set.cracks[c].firstVertex + v, side, d) = chains[c].links[v].face[side][d];
  Kokkos::deep_copy(set.face, face);
}

bool atFirstEnd(const CrackSet<2>& set, const CrackFront<2>& front)
{
  return front.vertex == set.cracks[front.crack].firstVertex;
}

} // namespace Rhegma::cracks
