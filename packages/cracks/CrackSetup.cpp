#include "cracks/CrackSetup.hpp"

#include "cracks/CrackFrames.hpp"
#include "cracks/CrackGeometry.hpp"
#include "cracks/CrackMesh.hpp"
#include "cracks/FrontPieces.hpp"
#include "scene/Attempts.hpp"
#include "scene/ReadList.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Rhegma::cracks
{

namespace
{

template <int D>
CrackMesh<D> readCrack(const Teuchos::ParameterList& list, const std::string& name,
                       const MaterialPlaces<D>& material, double spacing)
{
  if constexpr (D == 2)
    return readPolyline(list, "Cracks > " + name + " > Points", material, spacing);
  else
    return readPolygon(list, "Cracks > " + name, material, spacing);
}

template <int D>
void corners(const CrackMesh<D>& mesh, int s, Vector<D> (&corner)[D])
{
  for (int i = 0; i < D; ++i)
    corner[i] = mesh.vertices[mesh.simplices[s][i]];
}

/// Places on a simplex no further apart than half a cell.
template <int D>
std::vector<Vector<D>> placesOn(const CrackMesh<D>& mesh, int s, double spacing)
{
  Vector<D> corner[D];
  corners(mesh, s, corner);
  const int pieces = std::max(1, static_cast<int>(std::ceil(norm(corner[1] - corner[0]) / (0.5 * spacing))));
  std::vector<Vector<D>> places;
  if constexpr (D == 2) // segments are longer than triangles
    for (int i = 0; i <= pieces; ++i)
      places.push_back(corner[0] + (double(i) / pieces) * (corner[1] - corner[0]));
  else
    places.assign(corner, corner + 3);
  return places;
}

template <int D>
bool areClose(const CrackMesh<D>& a, const CrackMesh<D>& b, double spacing)
{
  constexpr double apart = 3.0; // cells
  for (std::size_t s = 0; s < a.simplices.size(); ++s)
    for (const Vector<D>& x : placesOn(a, static_cast<int>(s), spacing))
      for (std::size_t t = 0; t < b.simplices.size(); ++t)
      {
        Vector<D> corner[D];
        corners(b, static_cast<int>(t), corner);
        if (norm(x - placeOf<D>(corner, footOn(corner, x))) < apart * spacing)
          return true;
      }
  return false;
}

template <int D>
void refuseNeighbours(const std::vector<CrackMesh<D>>& all, const std::vector<std::string>& names,
                      double spacing)
{
  for (std::size_t a = 0; a < all.size(); ++a)
    for (std::size_t b = 0; b < all.size(); ++b)
      if (a != b && areClose(all[a], all[b], spacing))
        throw std::invalid_argument(
            "Cracks > " + names[a] + ": it comes closer than three cells to Cracks > " + names[b] +
            ", which this version can't tell apart; take smaller cells (Domain > Cell Size)");
}

template <int D>
void allocate(CrackSet<D>& set, int vertices, int simplices, int facets, int nodes)
{
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
  set.nodeSide = View<int*>("rhegma::nodeSide", nodes);
  set.second = View<int*>("rhegma::secondField", nodes);
  Kokkos::deep_copy(set.second, -1);
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
                beyond == facet::front ? vertexKind::front : vertexKind::mouth;
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

/// Marks the simplices from which a front may have to be looked at.
template <int D>
void markNearFront(CrackSet<D>& set, double spacing)
{
  const double reach = (bandWidth + 1.0) * spacing;
  const auto vertex = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, set.vertex);
  const auto simplex = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, set.simplex);
  const auto crackOf = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, set.crackOf);
  const auto frontFacet = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, set.frontFacet);
  const auto nearFront = Kokkos::create_mirror_view(set.nearFront);
  const auto at = [&](int v)
  {
    Vector<D> x;
    for (int d = 0; d < D; ++d)
      x[d] = vertex(v, d);
    return x;
  };
  for (std::size_t f = 0; f < frontFacet.extent(0); ++f)
  {
    const Vector<D> front = at(simplex(frontFacet(f, 0), (frontFacet(f, 1) + 1) % D));
    for (std::size_t s = 0; s < simplex.extent(0); ++s)
      if (crackOf(s) == crackOf(frontFacet(f, 0)))
      {
        Vector<D> corner[D];
        for (int i = 0; i < D; ++i)
          corner[i] = at(simplex(s, i));
        if (norm(front - placeOf<D>(corner, footOn(corner, front))) < reach)
          nearFront(s) = 1;
      }
  }
  Kokkos::deep_copy(set.nearFront, nearFront);
}

/// Where each vertex finds its simplices.
template <int D>
void listStars(CrackSet<D>& set)
{
  const int vertices = static_cast<int>(set.vertex.extent(0)),
            simplices = static_cast<int>(set.simplex.extent(0));
  const auto simplex = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, set.simplex);
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

} // namespace

template <int D>
void readCracks(const Teuchos::ParameterList& section, State<D>& state)
{
  const double spacing = state.grid.spacing;
  const MaterialPlaces<D> material(state);
  std::vector<CrackMesh<D>> meshes;
  std::vector<std::string> names;
  std::vector<Piece> pieces;
  CrackSet<D>& set = state.cracks;
  int vertices = 0, simplices = 0;
  Attempts attempts;
  for (const std::string& name : sublistNames(section))
  {
    CrackMesh<D> mesh;
    if (!attempts.attempt([&] { mesh = readCrack(section.sublist(name), name, material, spacing); }))
      continue;
    meshes.push_back(mesh);
    state.warnings.insert(state.warnings.end(), mesh.warnings.begin(), mesh.warnings.end());
    names.push_back(name);
    Crack<D> crack;
    crack.name = name;
    crack.firstVertex = vertices;
    crack.numVertices = static_cast<int>(mesh.vertices.size());
    crack.firstSimplex = simplices;
    crack.numSimplices = static_cast<int>(mesh.simplices.size());
    int number = 0;
    for (const std::vector<Piece>& along : frontsOf(mesh))
    {
      CrackFront<D> front;
      front.crack = static_cast<int>(set.cracks.size());
      front.number = number++;
      front.vertex = vertices + middleVertex(mesh, along);
      front.firstFacet = static_cast<int>(pieces.size());
      front.numFacets = static_cast<int>(along.size());
      for (const Piece& piece : along)
        pieces.push_back({simplices + piece.simplex, piece.facet});
      set.fronts.push_back(front);
    }
    set.cracks.push_back(crack);
    vertices += crack.numVertices;
    simplices += crack.numSimplices;
  }
  attempts.complain();
  refuseNeighbours(meshes, names, spacing);
  allocate(set, vertices, simplices, static_cast<int>(pieces.size()), state.grid.numNodes);
  fill(set, meshes, pieces);
  listStars(set);
  markNearFront(set, spacing);
  updateNormals(set);
  updateFronts(set);
}

template void readCracks(const Teuchos::ParameterList&, State<2>&);
template void readCracks(const Teuchos::ParameterList&, State<3>&);

} // namespace Rhegma::cracks
