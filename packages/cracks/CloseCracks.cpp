#include "cracks/CloseCracks.hpp"

#include "base/Numbers.hpp"
#include "geometry/NearBoxes.hpp"
#include "grid/LeafEdge.hpp"
#include "state/Subdomain.hpp"
#include "surface/NearestOnSimplex.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace Rhegma::cracks
{

namespace
{

constexpr double cellsApart = 3.0; ///< least distance of two cracks [cells]

template <int D>
using Corners = std::vector<std::array<Vector<D>, D>>;

/// The corners of the simplices of all cracks.
template <int D>
Corners<D> cornersOf(const CrackSet<D>& cracks)
{
  const auto vertex = onHost(cracks.vertex);
  const auto simplex = onHost(cracks.simplex);
  Corners<D> all(simplex.extent(0));
  for (std::size_t s = 0; s < all.size(); ++s)
    for (int i = 0; i < D; ++i)
      for (int d = 0; d < D; ++d)
        all[s][i][d] = vertex(simplex(s, i), d);
  return all;
}

/// Positions on a simplex no further apart than half the cells there, on a triangle than two of them.
template <int D, class Visit>
void visitPositions(const std::array<Vector<D>, D>& corner, const Branches<D>& refined, const Visit& visit)
{
  if constexpr (D == 3)
  {
    double edge = refined.grid().spacing, longest = 0.0;
    Vector<D> middle[D];
    for (int i = 0; i < D; ++i)
    {
      visit(corner[i], leafEdge(refined, corner[i]));
      const Vector<D>& next = corner[(i + 1) % D];
      longest = std::max(longest, norm(next - corner[i]));
      middle[i] = 0.5 * (corner[i] + next);
      edge = std::min({edge, leafEdge(refined, corner[i]), leafEdge(refined, middle[i])});
    }
    if (longest <= 2.0 * edge)
      return;
    visitPositions<D>({middle[0], middle[1], middle[2]}, refined, visit);
    for (int i = 0; i < D; ++i)
      visitPositions<D>({corner[i], middle[i], middle[(i + 2) % D]}, refined, visit);
  }
  else
  {
    const Vector<D> along = corner[1] - corner[0];
    const double length = norm(along);
    for (double at = 0.0; at < length;)
    {
      const Vector<D> x = corner[0] + (at / length) * along;
      const double edge = leafEdge(refined, x);
      visit(x, edge);
      at += 0.5 * edge;
    }
    visit(corner[1], leafEdge(refined, corner[1]));
  }
}

/// A place where two cracks are too near.
struct TooNear
{
  double distance = 0.0, edge = 0.0; ///< [m]
  bool found = false;
};

template <int D>
TooNear worstApproach(const Crack<D>& a, const Crack<D>& b, const Corners<D>& corners,
                      const Branches<D>& refined)
{
  TooNear worst;
  for (int s = a.firstSimplex; s < a.firstSimplex + a.numSimplices; ++s)
    visitPositions<D>(corners[s], refined,
                      [&](const Vector<D>& x, double edge)
                      {
                        for (int t = b.firstSimplex; t < b.firstSimplex + b.numSimplices; ++t)
                        {
                          Vector<D> other[D];
                          std::copy(corners[t].begin(), corners[t].end(), other);
                          const double distance = surface::distanceToSimplex(other, x);
                          if (distance < cellsApart * edge &&
                              (!worst.found || distance * worst.edge < worst.distance * edge))
                            worst = {distance, edge, true};
                        }
                      });
  return worst;
}

/// Cracks that cross do so at no cell size: positions are compared half a cell apart.
std::string messageOf(const std::string& one, const std::string& other, const TooNear& near)
{
  const std::string where = "Cracks > " + one + ": it ";
  if (near.distance < 0.25 * near.edge)
    return where + "meets or crosses Cracks > " + other +
           ", which is possible for cracks that grow but not at the start; let it end three cells (" +
           readableLength(cellsApart * near.edge) +
           ") before, or write both as one crack where one goes on "
           "from the other";
  return where + "comes as near as " + readableLength(near.distance) + " to Cracks > " + other +
         ", closer than three cells (of " + readableLength(near.edge) +
         " there), which cells can't separate; use smaller cells there (Domain > Cell Size, or a box in "
         "Adaptivity)";
}

/// The bounds of each crack.
template <int D>
std::vector<Geometry::Bounds<D>> boundsOf(const CrackSet<D>& set, const Corners<D>& corners)
{
  std::vector<Geometry::Bounds<D>> bounds;
  for (const Crack<D>& crack : set.cracks)
  {
    bounds.push_back(Geometry::emptyBounds<D>());
    for (int s = crack.firstSimplex; s < crack.firstSimplex + crack.numSimplices; ++s)
      for (const Vector<D>& x : corners[s])
        bounds.back().include(x);
  }
  return bounds;
}

/// Whether two bounds come within a distance of each other.
template <int D>
bool areNear(const Geometry::Bounds<D>& a, const Geometry::Bounds<D>& b, double distance)
{
  bool near = true;
  for (int d = 0; d < D; ++d)
    near = near && a.lower[d] < b.upper[d] + distance && b.lower[d] < a.upper[d] + distance;
  return near;
}

} // namespace

template <int D>
void refuseCloseCracks(const State<D>& state)
{
  const CrackSet<D>& set = state.cracks;
  if (set.cracks.size() < 2)
    return;
  const Branches<D> refined = refinedCells(state);
  const Corners<D> corners = cornersOf(set);
  const std::vector<Geometry::Bounds<D>> bounds = boundsOf<D>(set, corners);
  const Geometry::NearBoxes<D> boxes(bounds);
  for (std::size_t a = 0; a < set.cracks.size(); ++a)
    for (const int b : boxes.near(bounds[a], cellsApart * state.mesh.grid.spacing))
      if (static_cast<int>(a) != b)
        if (const TooNear near = worstApproach<D>(set.cracks[a], set.cracks[b], corners, refined); near.found)
          throw std::invalid_argument(messageOf(set.cracks[a].name, set.cracks[b].name, near));
}

template <int D>
void stopCracksThatMeet(State<D>& state)
{
  const std::vector<Crack<D>>& cracks = state.cracks.cracks;
  const auto isOfFirst = [&](const Crack<D>& crack) { return crack.bodyGroup == cracks.front().bodyGroup; };
  if (!state.failure.empty() || std::all_of(cracks.begin(), cracks.end(), isOfFirst))
    return;
  const Corners<D> corners = cornersOf(state.cracks);
  const std::vector<Geometry::Bounds<D>> bounds = boundsOf<D>(state.cracks, corners);
  const Branches<D> refined = refinedCells(state);
  for (std::size_t a = 0; a < cracks.size(); ++a)
    for (std::size_t b = a + 1; b < cracks.size(); ++b)
    {
      if (cracks[a].bodyGroup == cracks[b].bodyGroup ||
          !areNear(bounds[a], bounds[b], cellsApart * state.mesh.grid.spacing))
        continue;
      if (const TooNear near = worstApproach<D>(cracks[a], cracks[b], corners, refined); near.found)
        state.failure = "the cracks " + cracks[a].name + " and " + cracks[b].name +
                        ", of bodies that are not bonded, are " + readableLength(near.distance) +
                        " from each other, closer than three cells, which cells can't separate; use smaller "
                        "cells (Domain > Cell Size)";
    }
}

template void stopCracksThatMeet(State<2>&);
template void stopCracksThatMeet(State<3>&);
template void refuseCloseCracks(const State<2>&);
template void refuseCloseCracks(const State<3>&);

} // namespace Rhegma::cracks
