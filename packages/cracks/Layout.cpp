#include "cracks/Layout.hpp"

#include "cracks/CrackFrames.hpp"
#include "cracks/CrackGeometry.hpp"
#include "surface/FrontPieces.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace Rhegma::cracks
{

namespace
{

using surface::CrackMesh;
using surface::Piece;

template <int D>
void allocate(CrackSet<D>& set, int vertices, int simplices, int facets)
{
  ++set.changes;
  set.vertex = View<double* [D]>("rhegma::crackVertex", vertices);
  set.face = View<double* [2][D]>("rhegma::crackFace", vertices);
  set.kind = View<int*>("rhegma::crackVertexKind", vertices);
  set.vertexNormal = View<double* [D]>("rhegma::crackVertexNormal", vertices);
  set.simplex = View<int* [D]>("rhegma::crackSimplex", simplices);
  set.crackOf = View<int*>("rhegma::crackOf", simplices);
  set.neighbour = View<int* [D]>("rhegma::crackNeighbour", simplices);
  set.normal = View<double* [D]>("rhegma::crackNormal", simplices);
  set.nearFront = View<int*>("rhegma::crackNearFront", simplices);
  set.frontFacet = View<int* [2]>("rhegma::crackFrontFacet", facets);
  set.facetsOfCrack = View<int* [2]>("rhegma::crackFacetsOfCrack", set.cracks.size());
}

template <int D>
void fill(CrackSet<D>& set, const std::vector<CrackMesh<D>>& meshes, const std::vector<Piece>& pieces)
{
  const auto vertex = Kokkos::create_mirror_view(set.vertex);
  const auto face = Kokkos::create_mirror_view(set.face);
  const auto kind = Kokkos::create_mirror_view(set.kind);
  const auto simplex = Kokkos::create_mirror_view(set.simplex);
  const auto crackOf = Kokkos::create_mirror_view(set.crackOf);
  const auto neighbour = Kokkos::create_mirror_view(set.neighbour);
  const auto frontFacet = Kokkos::create_mirror_view(set.frontFacet);
  for (std::size_t c = 0; c < meshes.size(); ++c)
  {
    const CrackMesh<D>& mesh = meshes[c];
    const int v0 = set.cracks[c].firstVertex, s0 = set.cracks[c].firstSimplex;
    for (int v = 0; v < set.cracks[c].numVertices; ++v)
      for (int d = 0; d < D; ++d)
        vertex(v0 + v, d) = face(v0 + v, 0, d) = face(v0 + v, 1, d) = mesh.vertices[v][d];
    for (int s = 0; s < set.cracks[c].numSimplices; ++s)
    {
      crackOf(s0 + s) = static_cast<int>(c);
      for (int i = 0; i < D; ++i)
      {
        simplex(s0 + s, i) = v0 + mesh.simplices[s][i];
        const int beyond = mesh.beyond[s][i];
        neighbour(s0 + s, i) = beyond < 0 ? beyond : s0 + beyond;
        if (beyond < 0)
          for (int k = 1; k < D; ++k)
            kind(v0 + mesh.simplices[s][(i + k) % D]) |=
                beyond == facet::front ? vertexKind::front : vertexKind::surfaceBreaking;
      }
    }
  }
  for (std::size_t f = 0; f < pieces.size(); ++f)
  {
    frontFacet(f, 0) = pieces[f].simplex;
    frontFacet(f, 1) = pieces[f].facet;
  }
  Kokkos::deep_copy(set.vertex, vertex);
  Kokkos::deep_copy(set.face, face);
  Kokkos::deep_copy(set.kind, kind);
  Kokkos::deep_copy(set.simplex, simplex);
  Kokkos::deep_copy(set.crackOf, crackOf);
  Kokkos::deep_copy(set.neighbour, neighbour);
  Kokkos::deep_copy(set.frontFacet, frontFacet);
}

/// Lists which pieces of front belong to the fronts of each crack.
template <int D>
void listFacets(CrackSet<D>& set)
{
  const auto range = Kokkos::create_mirror_view(set.facetsOfCrack);
  for (std::size_t c = 0; c < set.cracks.size(); ++c)
  {
    range(c, 0) = static_cast<int>(set.frontFacet.extent(0));
    range(c, 1) = 0;
  }
  for (const CrackFront<D>& front : set.fronts)
    if (front.numFacets > 0)
    {
      range(front.crack, 0) = std::min(range(front.crack, 0), front.firstFacet);
      range(front.crack, 1) = std::max(range(front.crack, 1), front.firstFacet + front.numFacets);
    }
  Kokkos::deep_copy(set.facetsOfCrack, range);
}

/// A point of a facet of a front.
template <int D>
struct PointOfFront
{
  Vector<D> position; ///< [m]
  bool grown;         ///< CrackFront::grown
};

/// Marks the simplices near fronts by the nearest one.
template <int D>
void markNearFront(CrackSet<D>& set, double spacing)
{
  const double reach = (bandWidth + 1.0) * spacing;
  const auto vertex = onHost(set.vertex);
  const auto simplex = onHost(set.simplex);
  const auto crackOf = onHost(set.crackOf);
  const auto frontFacet = onHost(set.frontFacet);
  const auto nearFront = Kokkos::create_mirror_view(set.nearFront);
  const auto at = [&](int v)
  {
    Vector<D> x;
    for (int d = 0; d < D; ++d)
      x[d] = vertex(v, d);
    return x;
  };
  std::vector<std::vector<PointOfFront<D>>> frontsOf(set.cracks.size()); // of a crack
  for (const CrackFront<D>& front : set.fronts)
    for (int f = front.firstFacet; f < front.firstFacet + front.numFacets; ++f)
      frontsOf[crackOf(frontFacet(f, 0))].push_back(
          {at(simplex(frontFacet(f, 0), (frontFacet(f, 1) + 1) % D)), front.grown});
  for (std::size_t s = 0; s < simplex.extent(0); ++s)
  {
    Vector<D> corner[D];
    for (int i = 0; i < D; ++i)
      corner[i] = at(simplex(s, i));
    double radius = 0.0; // of a sphere round the first corner
    for (int i = 1; i < D; ++i)
      radius = std::max(radius, norm(corner[i] - corner[0]));
    const double most = (reach + radius) * (reach + radius);
    double nearest = reach;
    for (const PointOfFront<D>& front : frontsOf[crackOf(s)])
    {
      const Vector<D> from = front.position - corner[0];
      if (dot(from, from) >= most)
        continue;
      const double distance = surface::distanceToSimplex(corner, front.position);
      if (distance >= nearest)
        continue;
      nearest = distance;
      nearFront(s) = front.grown ? nearFront::grown : nearFront::hasSprings;
    }
  }
  Kokkos::deep_copy(set.nearFront, nearFront);
}

/// The simplices of each vertex.
template <int D>
void listStars(CrackSet<D>& set)
{
  const int vertices = static_cast<int>(set.vertex.extent(0)),
            simplices = static_cast<int>(set.simplex.extent(0));
  const auto simplex = onHost(set.simplex);
  std::vector<std::vector<int>> stars(vertices);
  for (int s = 0; s < simplices; ++s)
    for (int i = 0; i < D; ++i)
      stars[simplex(s, i)].push_back(s);
  set.starBegin = View<int*>("rhegma::crackStarBegin", vertices + 1);
  set.star = View<int*>("rhegma::crackStar", D * simplices);
  const auto begin = Kokkos::create_mirror_view(set.starBegin);
  const auto star = Kokkos::create_mirror_view(set.star);
  for (int v = 0; v < vertices; ++v)
  {
    begin(v + 1) = begin(v) + static_cast<int>(stars[v].size());
    std::copy(stars[v].begin(), stars[v].end(), star.data() + begin(v));
  }
  Kokkos::deep_copy(set.starBegin, begin);
  Kokkos::deep_copy(set.star, star);
}

/// The pieces of a front whose front nodes are given, by vertices of its crack.
std::vector<Piece> piecesOf(const CrackFront<3>& front, const CrackMesh<3>& mesh)
{
  std::map<std::pair<int, int>, Piece> border;
  for (std::size_t s = 0; s < mesh.simplices.size(); ++s)
    for (int i = 0; i < 3; ++i)
      if (mesh.beyond[s][i] == facet::front)
        border[{mesh.simplices[s][(i + 1) % 3], mesh.simplices[s][(i + 2) % 3]}] = {static_cast<int>(s), i};
  std::vector<Piece> pieces;
  for (std::size_t k = 0; k < front.nodes.size(); ++k)
  {
    const FrontNode<3>& next = front.nodes[k + 1 < front.nodes.size() ? k + 1 : 0];
    if (front.nodes[k].facet >= 0)
      pieces.push_back(border.at({front.nodes[k].vertex, next.vertex}));
  }
  return pieces;
}

/// The front nodes of a front from its pieces, which are one line, by vertices of its crack.
std::vector<FrontNode<3>> frontNodesOf(const CrackMesh<3>& mesh, const std::vector<Piece>& pieces)
{
  std::vector<FrontNode<3>> frontNodes;
  const auto add = [&](const Piece& piece, int end, int facet)
  {
    FrontNode<3> frontNode;
    frontNode.vertex = mesh.simplices[piece.simplex][(piece.facet + end) % 3];
    frontNode.name = static_cast<int>(frontNodes.size());
    frontNode.facet = facet;
    frontNodes.push_back(frontNode);
  };
  for (const Piece& piece : pieces)
    add(piece, 1, 0);
  add(pieces.back(), 2, -1);
  if (frontNodes.back().vertex == frontNodes.front().vertex)
    frontNodes.pop_back();
  return frontNodes;
}

/// Gives the front nodes of a front their numbers in the set.
void numberFrontNodes(CrackFront<3>& front, int firstVertex)
{
  int facet = front.firstFacet;
  for (FrontNode<3>& frontNode : front.nodes)
  {
    frontNode.vertex += firstVertex;
    frontNode.facet = frontNode.facet >= 0 ? facet++ : -1;
  }
}

/// Gives the fronts of a crack their pieces. \return the pieces, in the set's numbering
template <int D>
std::vector<Piece> setFrontPieces(CrackSet<D>& set, const std::vector<CrackMesh<D>>& meshes)
{
  std::vector<Piece> pieces;
  std::vector<std::vector<std::vector<Piece>>> fronts;
  fronts.reserve(meshes.size());
  for (const CrackMesh<D>& mesh : meshes)
    fronts.push_back(surface::frontsOf(mesh));
  std::vector<std::size_t> next(meshes.size(), 0);
  for (CrackFront<D>& front : set.fronts)
  {
    front.firstFacet = static_cast<int>(pieces.size());
    front.numFacets = 0;
    if (front.ended)
      continue;
    std::vector<Piece> along;
    if (D == 2 || front.nodes.empty())
      along = fronts[front.crack][next[front.crack]++];
    const Crack<D>& crack = set.cracks[front.crack];
    if constexpr (D == 3)
    {
      if (front.nodes.empty())
        front.nodes = frontNodesOf(meshes[front.crack], along);
      along = piecesOf(front, meshes[front.crack]);
      numberFrontNodes(front, crack.firstVertex);
    }
    front.vertex = crack.firstVertex + surface::middleVertex(meshes[front.crack], along);
    if constexpr (D == 2)
    {
      front.nodes[0].vertex = front.vertex;
      front.nodes[0].facet = front.firstFacet;
    }
    front.numFacets = static_cast<int>(along.size());
    for (const Piece& piece : along)
      pieces.push_back({crack.firstSimplex + piece.simplex, piece.facet});
  }
  return pieces;
}

} // namespace

template <int D>
void layOut(CrackSet<D>& set, const std::vector<CrackMesh<D>>& meshes, double spacing)
{
  int vertices = 0, simplices = 0;
  for (std::size_t c = 0; c < meshes.size(); ++c)
  {
    Crack<D>& crack = set.cracks[c];
    crack.firstVertex = vertices;
    crack.numVertices = static_cast<int>(meshes[c].vertices.size());
    crack.firstSimplex = simplices;
    crack.numSimplices = static_cast<int>(meshes[c].simplices.size());
    vertices += crack.numVertices;
    simplices += crack.numSimplices;
  }
  const std::vector<Piece> pieces = setFrontPieces(set, meshes);
  allocate(set, vertices, simplices, static_cast<int>(pieces.size()));
  fill(set, meshes, pieces);
  listFacets(set);
  listStars(set);
  markNearFront(set, spacing);
  updateNormals(set);
  updateFronts(set);
}

template void layOut(CrackSet<2>&, const std::vector<CrackMesh<2>>&, double);
template void layOut(CrackSet<3>&, const std::vector<CrackMesh<3>>&, double);

} // namespace Rhegma::cracks
