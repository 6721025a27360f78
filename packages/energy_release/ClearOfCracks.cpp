#include "energy_release/ClearOfCracks.hpp"

#include "energy_release/PointBounds.hpp"
#include "plausibility/CrackBounds.hpp"
#include "surface/Returns.hpp"

#include <algorithm>

namespace Rhegma::energy_release
{

namespace
{

/// A crack of a set, its vertices and simplices counted from 0. \param vertex and the others are the set's,
/// on the host
template <int D, class Vertices, class Simplices>
surface::CrackMesh<D> meshOf(const Crack<D>& crack, const Vertices& vertex, const Simplices& simplex,
                             const Simplices& neighbour)
{
  surface::CrackMesh<D> mesh;
  mesh.vertices.resize(crack.numVertices);
  for (int v = 0; v < crack.numVertices; ++v)
    for (int d = 0; d < D; ++d)
      mesh.vertices[v][d] = vertex(crack.firstVertex + v, d);
  mesh.simplices.resize(crack.numSimplices);
  mesh.beyond.resize(crack.numSimplices);
  for (int s = 0; s < crack.numSimplices; ++s)
    for (int i = 0; i < D; ++i)
    {
      const int from = crack.firstSimplex + s;
      const int beyond = neighbour.extent(0) > 0 ? neighbour(from, i) : facet::surfaceBreaking;
      mesh.simplices[s][i] = simplex(from, i) - crack.firstVertex;
      mesh.beyond[s][i] = beyond >= 0 ? beyond - crack.firstSimplex : beyond;
    }
  return mesh;
}

/// Nodes nearer than a cell to a crack are split by it, and particles of both of its sides strain by them.
constexpr double marginCells = 1.0;
/// The smallest radius may reach into them: better than none.
constexpr double smallestCells = 2.0;

} // namespace

template <int D>
double clearOfCracks(const CrackSet<D>& cracks, const CrackFront<D>& front, double radius, double cell)
{
  constexpr double slack = 1.5; // cells
  const double margin = marginCells * cell;
  const std::vector<Vector<D>> points = front.points();
  if (points.empty() || front.numFacets == 0)
    return radius;
  const auto vertex = onHost(cracks.vertex);
  const auto simplex = onHost(cracks.simplex), neighbour = onHost(cracks.neighbour);
  const auto frontFacet = onHost(cracks.frontFacet);
  const Geometry::Bounds<D> bounds = boundsOf(points);
  for (int c = 0; c < static_cast<int>(cracks.cracks.size()); ++c)
  {
    const Crack<D>& crack = cracks.cracks[c];
    std::vector<int> start;
    if (c == front.crack && crack.numSimplices > 1)
      for (int f = front.firstFacet; f < front.firstFacet + front.numFacets; ++f)
        start.push_back(frontFacet(f, 0) - crack.firstSimplex);
    if ((c == front.crack && start.empty()) ||
        !areNear(boundsOfCrack(crack, vertex), bounds, radius + margin))
      continue;
    const surface::CrackMesh<D> mesh = meshOf(crack, vertex, simplex, neighbour);
    const double found = surface::Returns<D>(mesh).find(start, points, radius + margin, slack * cell);
    radius = std::min(radius, std::max(found - margin, std::min(found, smallestCells * cell)));
  }
  return radius;
}

template double clearOfCracks(const CrackSet<2>&, const CrackFront<2>&, double, double);
template double clearOfCracks(const CrackSet<3>&, const CrackFront<3>&, double, double);

} // namespace Rhegma::energy_release
