#pragma once
/// Where a point lies with respect to a crack.

#include "state/CrackSet.hpp"
#include "surface/NearestOnSimplex.hpp"

namespace Rhegma::cracks
{

/// Distance from a crack within which nodes have a side [cells]: a particle a stencil away on the other side
/// must find the node's side.
constexpr double bandWidth = 3.0;

/// A point seen from a crack that is continued straight on beyond its surface-breaking ends and its fronts.
struct Sight
{
  double distance; ///< from the continued crack, positive on side +1 [m]
  double behind; ///< by how far the point lies behind the nearest front, negative ahead of it; huge away from
                 ///< fronts [m]
};

using surface::Foot;
using surface::footOn;
using surface::pointAt;

/// Flags of CrackSet::nearFront.
namespace nearFront
{
constexpr int away = 0;
constexpr int hasSprings = 1;      ///< its crack may have front springs
constexpr int springsDisabled = 2; ///< near a front as well, its crack without springs (AdvectedFronts.hpp)
constexpr int grown = 3;           ///< its crack may have front springs, and the front has grown

KOKKOS_INLINE_FUNCTION bool mayHaveSprings(int flag) { return flag == hasSprings || flag == grown; }
} // namespace nearFront

/// Locates points with respect to cracks, in kernels.
template <int D>
struct CrackSight
{
  View<double*[D]> vertex, vertexNormal, normal;
  View<int*[D]> simplex, neighbour;
  View<int*[2]> frontFacet, facetsOfCrack;
  View<int*> crackOf, kind, nearFront;
  double extension; ///< how far a front is continued straight beyond the surface [m]

  CrackSight(const CrackSet<D>& cracks, double spacing)
      : vertex(cracks.vertex),
        vertexNormal(cracks.vertexNormal),
        normal(cracks.normal),
        simplex(cracks.simplex),
        neighbour(cracks.neighbour),
        frontFacet(cracks.frontFacet),
        facetsOfCrack(cracks.facetsOfCrack),
        crackOf(cracks.crackOf),
        kind(cracks.kind),
        nearFront(cracks.nearFront),
        extension((bandWidth + 2.0) * spacing)
  {
  }

  KOKKOS_INLINE_FUNCTION void corners(int s, Vector<D> (&corner)[D]) const
  {
    for (int i = 0; i < D; ++i)
      for (int d = 0; d < D; ++d)
        corner[i][d] = vertex(simplex(s, i), d);
  }

  /// Square of the distance of x from simplex s [m2].
  KOKKOS_INLINE_FUNCTION double square(int s, const Vector<D>& x) const
  {
    Vector<D> corner[D];
    corners(s, corner);
    const Vector<D> away = x - pointAt<D>(corner, footOn(corner, x));
    return dot(away, away);
  }

  /// Locates x with respect to simplex s, which should be the nearest to it. The side is that of the normal
  /// of the simplex, edge or vertex on which the nearest point lies, so that sides change nowhere but on the
  /// continued crack (Baerentzen and Aanaes, IEEE Trans. Vis. Comput. Graph. 11 (2005) 243).
  KOKKOS_INLINE_FUNCTION Sight locate(int s, const Vector<D>& x) const
  {
    Vector<D> corner[D];
    corners(s, corner);
    const Foot<D> foot = footOn(corner, x);
    const Vector<D> away = x - pointAt<D>(corner, foot);
    Vector<D> n, m;
    for (int d = 0; d < D; ++d)
      n[d] = m[d] = normal(s, d);
    int beyond = 0; // what is beyond the nearest point (FacetEnds.hpp); 0: the point is inside
    if (foot.vertex >= 0)
    {
      const int v = simplex(s, foot.vertex);
      for (int d = 0; d < D; ++d)
        m[d] = vertexNormal(v, d);
      beyond = kind(v) == vertexKind::inner   ? 0
               : kind(v) == vertexKind::front ? facet::front
                                              : facet::surfaceBreaking;
    }
    else if (foot.facet >= 0)
    {
      const int other = neighbour(s, foot.facet);
      beyond = other < 0 ? other : 0;
      if (other >= 0)
        for (int d = 0; d < D; ++d)
          m[d] += normal(other, d);
    }
    const double side = dot(away, m);
    Sight sight;
    sight.distance = beyond != 0 ? dot(away, n) : side >= 0.0 ? norm(away) : -norm(away);
    sight.behind = nearFront(s) != 0 ? behindFront(s, x, n, beyond) : 1e300;
    return sight;
  }

private:
  /// By how far the projection of x along n lies behind the front pieces of the crack that simplex s is of.
  KOKKOS_INLINE_FUNCTION double behindFront(int s, const Vector<D>& x, const Vector<D>& n, int beyond) const
  {
    double nearest = 1e300;
    bool inward = true;
    const int own = crackOf(s);
    const bool listed = facetsOfCrack.extent(0) > 0;
    const int first = listed ? facetsOfCrack(own, 0) : 0,
              end = listed ? facetsOfCrack(own, 1) : static_cast<int>(frontFacet.extent(0));
    for (int f = first; f < end; ++f)
    {
      const int t = frontFacet(f, 0), opposite = frontFacet(f, 1);
      if (crackOf(t) != own)
        continue;
      Vector<D> corner[D];
      corners(t, corner);
      const Vector<D>& a = corner[(opposite + 1) % D];
      Vector<D> from = x - a, in = corner[opposite] - a;
      from = from - dot(from, n) * n;
      if constexpr (D == 3)
      {
        const Vector<D> along = corner[(opposite + 2) % D] - a;
        const double square = dot(along, along), reach = extension / std::sqrt(square);
        // A front that ends at the surface is continued beyond it.
        const double low = kind(simplex(t, (opposite + 1) % D)) == vertexKind::front ? 0.0 : -reach;
        const double high = kind(simplex(t, (opposite + 2) % D)) == vertexKind::front ? 1.0 : 1.0 + reach;
        double at = dot(from, along) / square;
        at = at < low ? low : (at > high ? high : at);
        from = from - at * along;
        in = in - (dot(in, along) / square) * along;
      }
      const double distance = norm(from);
      if (distance < nearest)
      {
        nearest = distance;
        inward = dot(from, in) >= 0.0;
      }
    }
    const bool isBehind = beyond == 0 || (beyond == facet::surfaceBreaking && inward);
    return isBehind ? nearest : -nearest;
  }
};

} // namespace Rhegma::cracks
