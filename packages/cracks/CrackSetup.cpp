#include "cracks/CrackSetup.hpp"

#include "base/Attempts.hpp"
#include "base/ReadList.hpp"
#include "cracks/CrackGeometry.hpp"
#include "cracks/CrackMesh.hpp"
#include "cracks/FrontPieces.hpp"
#include "cracks/Layout.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Rhegma::cracks
{

namespace
{

template <int D>
CrackMesh<D> readCrack(const Teuchos::ParameterList& list, const std::string& name,
                       const MaterialPlaces<D>& material, double spacing, [[maybe_unused]] double edge)
{
  if constexpr (D == 2)
    return readPolyline(list, "Cracks > " + name + " > Points", material, spacing);
  else if (list.isParameter("Surface File"))
    return readSurface(list, "Cracks > " + name, material, spacing, edge);
  else if (list.isParameter("Radius"))
    return readDisk(list, "Cracks > " + name, material, spacing, edge);
  else
    return readPolygon(list, "Cracks > " + name, material, spacing, edge);
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

} // namespace

template <int D>
void readCracks(const Teuchos::ParameterList& section, State<D>& state, double edge)
{
  const double spacing = state.mesh.grid.spacing;
  const MaterialPlaces<D> material(state);
  std::vector<CrackMesh<D>> meshes;
  std::vector<std::string> names;
  CrackSet<D>& set = state.cracks;
  Attempts attempts;
  for (const std::string& name : sublistNames(section))
  {
    CrackMesh<D> mesh;
    if (!attempts.attempt([&] { mesh = readCrack(section.sublist(name), name, material, spacing, edge); }))
      continue;
    meshes.push_back(mesh);
    state.warnings.insert(state.warnings.end(), mesh.warnings.begin(), mesh.warnings.end());
    names.push_back(name);
    Crack<D> crack;
    crack.name = name;
    const int numFronts = static_cast<int>(frontsOf(mesh).size());
    for (int number = 0; number < numFronts; ++number)
    {
      CrackFront<D> front;
      front.crack = static_cast<int>(set.cracks.size());
      front.number = number;
      set.fronts.push_back(front);
    }
    set.cracks.push_back(crack);
  }
  attempts.complain();
  refuseNeighbours(meshes, names, spacing);
  layOut(set, meshes, spacing);
  set.nodeSide = View<int*>("rhegma::nodeSide", state.mesh.grid.numNodes);
  set.second = View<int*>("rhegma::secondField", state.mesh.grid.numNodes);
  Kokkos::deep_copy(set.second, -1);
}

template void readCracks(const Teuchos::ParameterList&, State<2>&, double);
template void readCracks(const Teuchos::ParameterList&, State<3>&, double);

} // namespace Rhegma::cracks
