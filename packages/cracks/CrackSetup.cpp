#include "cracks/CrackSetup.hpp"

#include "base/Attempts.hpp"
#include "base/ReadList.hpp"
#include "cracks/CrackGeometry.hpp"
#include "cracks/Layout.hpp"
#include "cracks/ReadCrack.hpp"
#include "geometry/NearBoxes.hpp"
#include "surface/FrontPieces.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace Rhegma::cracks
{

namespace
{

template <int D>
void corners(const surface::CrackMesh<D>& mesh, int s, Vector<D> (&corner)[D])
{
  for (int i = 0; i < D; ++i)
    corner[i] = mesh.vertices[mesh.simplices[s][i]];
}

/// Points on a simplex no further apart than half a cell.
template <int D>
std::vector<Vector<D>> pointsOn(const surface::CrackMesh<D>& mesh, int s, double spacing)
{
  Vector<D> corner[D];
  corners(mesh, s, corner);
  const int pieces = std::max(1, static_cast<int>(std::ceil(norm(corner[1] - corner[0]) / (0.5 * spacing))));
  std::vector<Vector<D>> points;
  if constexpr (D == 2) // segments are longer than triangles
    for (int i = 0; i <= pieces; ++i)
      points.push_back(corner[0] + (double(i) / pieces) * (corner[1] - corner[0]));
  else
    points.assign(corner, corner + 3);
  return points;
}

constexpr double apart = 3.0; ///< least distance of two cracks [cells]

template <int D>
bool areClose(const surface::CrackMesh<D>& a, const surface::CrackMesh<D>& b, double spacing)
{
  for (std::size_t s = 0; s < a.simplices.size(); ++s)
    for (const Vector<D>& x : pointsOn(a, static_cast<int>(s), spacing))
      for (std::size_t t = 0; t < b.simplices.size(); ++t)
      {
        Vector<D> corner[D];
        corners(b, static_cast<int>(t), corner);
        if (surface::distanceToSimplex(corner, x) < apart * spacing)
          return true;
      }
  return false;
}

template <int D>
void refuseNeighbours(const std::vector<surface::CrackMesh<D>>& all, const std::vector<std::string>& names,
                      double spacing)
{
  std::vector<Geometry::Bounds<D>> bounds;
  bounds.reserve(all.size());
  for (const surface::CrackMesh<D>& mesh : all)
  {
    bounds.push_back(Geometry::emptyBounds<D>());
    for (const Vector<D>& x : mesh.vertices)
      bounds.back().include(x);
  }
  const Geometry::NearBoxes<D> boxes(bounds);
  for (std::size_t a = 0; a < all.size(); ++a)
    for (const int b : boxes.near(bounds[a], apart * spacing))
      if (static_cast<int>(a) != b && areClose(all[a], all[b], spacing))
        throw std::invalid_argument("Cracks > " + names[a] +
                                    ": it comes closer than three cells to Cracks > " + names[b] +
                                    ", which cells can't separate; use smaller cells (Domain > Cell Size)");
}

} // namespace

template <int D>
void readCracks(const Teuchos::ParameterList& section, State<D>& state, double edge)
{
  const double spacing = state.mesh.grid.spacing;
  const BodyRegion<D> bodies(state);
  const ReadingContext<D> context{bodies, spacing, edge};
  std::vector<surface::CrackMesh<D>> meshes;
  std::vector<std::string> names;
  CrackSet<D>& set = state.cracks;
  Attempts attempts;
  for (const std::string& name : sublistNames(section))
  {
    surface::CrackMesh<D> mesh;
    if (!attempts.attempt(
            [&] { mesh = readCrack(section.sublist(name), "Cracks > " + name, context, state.warnings); }))
      continue;
    const int numFronts = static_cast<int>(surface::frontsOf(mesh).size());
    meshes.push_back(std::move(mesh));
    names.push_back(name);
    Crack<D> crack;
    crack.name = name;
    for (int number = 0; number < numFronts; ++number)
    {
      CrackFront<D> front;
      front.crack = static_cast<int>(set.cracks.size());
      front.number = number;
      set.fronts.push_back(front);
    }
    set.cracks.push_back(crack);
  }
  attempts.throwIfAny();
  refuseNeighbours(meshes, names, spacing);
  layOut(set, meshes, spacing);
  set.nodeSide = View<int*>("rhegma::nodeSide", state.mesh.grid.numNodes);
  set.enrichedField = View<int*>("rhegma::enrichedField", state.mesh.grid.numNodes);
  Kokkos::deep_copy(set.enrichedField, -1);
}

template void readCracks(const Teuchos::ParameterList&, State<2>&, double);
template void readCracks(const Teuchos::ParameterList&, State<3>&, double);

} // namespace Rhegma::cracks
