#include "cracks/CrackFrames.hpp"

#include "geometry/Cross.hpp"
#include "state/FewItems.hpp"

#include <cmath>

namespace Rhegma::cracks
{

namespace
{

template <int D>
KOKKOS_INLINE_FUNCTION Vector<D> unit(const Vector<D>& a)
{
  return (1.0 / norm(a)) * a;
}

KOKKOS_INLINE_FUNCTION Vector<2> normalOf(const Vector<2> (&corner)[2])
{
  return unit(Vector<2>{corner[0][1] - corner[1][1], corner[1][0] - corner[0][0]});
}

KOKKOS_INLINE_FUNCTION Vector<3> normalOf(const Vector<3> (&corner)[3])
{
  return unit(cross(corner[1] - corner[0], corner[2] - corner[0]));
}

/// Weight of a simplex's normal at its i-th vertex: its angle there.
template <int D>
KOKKOS_INLINE_FUNCTION double angleAt(const Vector<D> (&corner)[D], int i)
{
  if constexpr (D == 2)
    return 1.0;
  else
  {
    const double cosine = dot(unit(corner[(i + 1) % D] - corner[i]), unit(corner[(i + 2) % D] - corner[i]));
    return std::acos(cosine < -1.0 ? -1.0 : (cosine > 1.0 ? 1.0 : cosine));
  }
}

} // namespace

template <int D>
void updateNormals(const CrackSet<D>& cracks)
{
  const auto vertex = cracks.vertex, normal = cracks.normal, vertexNormal = cracks.vertexNormal;
  const auto simplex = cracks.simplex;
  const View<int*> starBegin = cracks.starBegin, star = cracks.star;
  const auto corners = KOKKOS_LAMBDA(const int s, Vector<D>(&corner)[D])
  {
    for (int i = 0; i < D; ++i)
      for (int d = 0; d < D; ++d)
        corner[i][d] = vertex(simplex(s, i), d);
  };
  forFew(
      "rhegma::cracks::normals", static_cast<int>(simplex.extent(0)), KOKKOS_LAMBDA(const int s) {
        Vector<D> corner[D];
        corners(s, corner);
        const Vector<D> n = normalOf(corner);
        for (int d = 0; d < D; ++d)
          normal(s, d) = n[d];
      });
  forFew(
      "rhegma::cracks::vertexNormals", static_cast<int>(vertex.extent(0)), KOKKOS_LAMBDA(const int v) {
        Vector<D> sum{};
        for (int k = starBegin(v); k < starBegin(v + 1); ++k)
        {
          const int s = star(k);
          Vector<D> corner[D];
          corners(s, corner);
          for (int i = 0; i < D; ++i)
            if (simplex(s, i) == v)
              sum = sum + angleAt<D>(corner, i) * normalOf(corner);
        }
        const Vector<D> n = unit(sum);
        for (int d = 0; d < D; ++d)
          vertexNormal(v, d) = n[d];
      });
}

template <int D>
void updateFronts(CrackSet<D>& cracks)
{
  if (cracks.fronts.empty())
    return;
  const auto vertex = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, cracks.vertex);
  const auto simplex = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, cracks.simplex);
  const auto frontFacet = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, cracks.frontFacet);
  const auto at = [&](int v)
  {
    Vector<D> x;
    for (int d = 0; d < D; ++d)
      x[d] = vertex(v, d);
    return x;
  };
  const auto edge = [&](int s, int i) { return at(simplex(s, (i + 2) % D)) - at(simplex(s, (i + 1) % D)); };
  for (CrackFront<D>& front : cracks.fronts)
  {
    front.length = 0.0;
    if constexpr (D == 2)
    {
      const Crack<D>& crack = cracks.cracks[front.crack];
      for (int k = 0; k < crack.numSimplices; ++k)
        front.length += norm(at(simplex(crack.firstSimplex + k, 1)) - at(simplex(crack.firstSimplex + k, 0)));
    }
    front.position = at(front.vertex);
    if (front.ended)
      continue;
    const int middle = front.firstFacet + front.numFacets / 2;
    const int s = frontFacet(middle, 0), opposite = frontFacet(middle, 1);
    Vector<D> corner[D];
    for (int i = 0; i < D; ++i)
      corner[i] = at(simplex(s, i));
    Vector<D> out = corner[(opposite + 1) % D] - corner[opposite];
    if constexpr (D == 3)
    {
      const Vector<D> along = edge(s, opposite);
      out = out - (dot(out, along) / dot(along, along)) * along;
      for (int f = front.firstFacet; f < front.firstFacet + front.numFacets; ++f)
        front.length += norm(edge(frontFacet(f, 0), frontFacet(f, 1)));
    }
    front.direction = unit(out);
    front.normal = normalOf(corner);
  }
}

template void updateNormals(const CrackSet<2>&);
template void updateNormals(const CrackSet<3>&);
template void updateFronts(CrackSet<2>&);
template void updateFronts(CrackSet<3>&);

} // namespace Rhegma::cracks
