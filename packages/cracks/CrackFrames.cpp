#include "cracks/CrackFrames.hpp"

#include "base/SmallLoops.hpp"
#include "geometry/Cross.hpp"

#include <cmath>
#include <vector>

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
  parallelForSmall(
      "rhegma::cracks::normals", static_cast<int>(simplex.extent(0)), KOKKOS_LAMBDA(const int s) {
        Vector<D> corner[D];
        corners(s, corner);
        const Vector<D> n = normalOf(corner);
        for (int d = 0; d < D; ++d)
          normal(s, d) = n[d];
      });
  parallelForSmall(
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

namespace
{

/// Fractions, positions and directions of the front nodes of 3D fronts.
class FrontNodeFrames
{
public:
  explicit FrontNodeFrames(const CrackSet<3>& cracks)
      : vertex_(onHost(cracks.vertex)),
        simplex_(onHost(cracks.simplex)),
        neighbour_(onHost(cracks.neighbour)),
        frontFacet_(onHost(cracks.frontFacet)),
        starBegin_(onHost(cracks.starBegin)),
        star_(onHost(cracks.star))
  {
  }

  void update(CrackFront<3>& front) const
  {
    const Vector<3> none{0.0, 0.0, 0.0};
    std::vector<FrontNode<3>>& frontNodes = front.nodes;
    for (FrontNode<3>& frontNode : frontNodes)
    {
      frontNode.position = at(frontNode.vertex);
      frontNode.tributaryLength = 0.0;
      frontNode.direction = frontNode.normal = none;
    }
    std::vector<bool> ends(frontNodes.size(), true);
    int before = -1;
    for (std::size_t k = 0; k < frontNodes.size(); ++k)
    {
      if (before >= 0)
      {
        add(frontNodes[before].facet, frontNodes[k]);
        ends[k] = false;
      }
      before = frontNodes[k].facet >= 0 ? static_cast<int>(k) : -1;
      if (frontNodes[k].facet >= 0)
        add(frontNodes[k].facet, frontNodes[k]);
      else
        ends[k] = true;
    }
    if (before >= 0) // the line is closed
    {
      add(frontNodes[before].facet, frontNodes[0]);
      ends[0] = false;
    }
    for (std::size_t k = 0; k < frontNodes.size(); ++k)
    {
      FrontNode<3>& frontNode = frontNodes[k];
      frontNode.normal = unit(frontNode.normal);
      frontNode.direction = across(frontNode.direction, frontNode.normal);
      if (ends[k])
        frontNode.direction = alongSurface(frontNode);
    }
  }

private:
  Vector<3> at(int v) const { return {vertex_(v, 0), vertex_(v, 1), vertex_(v, 2)}; }

  static Vector<3> across(const Vector<3>& a, const Vector<3>& n) { return unit(a - dot(a, n) * n); }

  /// Adds half the length of a piece, and its direction and normal weighted by it.
  void add(int facet, FrontNode<3>& frontNode) const
  {
    const int s = frontFacet_(facet, 0), opposite = frontFacet_(facet, 1);
    const Vector<3> a = at(simplex_(s, (opposite + 1) % 3)), b = at(simplex_(s, (opposite + 2) % 3)),
                    c = at(simplex_(s, opposite));
    const Vector<3> along = b - a, n = unit(cross(along, c - a));
    frontNode.tributaryLength += 0.5 * norm(along);
    frontNode.normal = frontNode.normal + norm(along) * n;
    frontNode.direction = frontNode.direction + cross(along, n);
  }

  /// The direction in which the surface-breaking edge continues at the end of a front; the direction across
  /// the front if the two are apart by more than 60 degrees: then that edge does not follow the surface. A
  /// front may meet a flat surface at a small angle, so a smaller limit would turn its end into the body.
  Vector<3> alongSurface(const FrontNode<3>& frontNode) const
  {
    constexpr double grazing = 0.5;
    for (int k = starBegin_(frontNode.vertex); k < starBegin_(frontNode.vertex + 1); ++k)
    {
      const int s = star_(k);
      for (int i = 0; i < 3; ++i)
      {
        const int a = simplex_(s, (i + 1) % 3), b = simplex_(s, (i + 2) % 3);
        if (neighbour_(s, i) != facet::surfaceBreaking || (a != frontNode.vertex && b != frontNode.vertex))
          continue;
        const Vector<3> out =
            across(frontNode.position - at(a == frontNode.vertex ? b : a), frontNode.normal);
        if (dot(out, frontNode.direction) > grazing)
          return out;
      }
    }
    return frontNode.direction;
  }

  typename View<double* [3]>::HostMirror vertex_;
  typename View<int*[3]>::HostMirror simplex_, neighbour_;
  typename View<int* [2]>::HostMirror frontFacet_;
  typename View<int*>::HostMirror starBegin_, star_;
};

} // namespace

template <int D>
void updateFronts(CrackSet<D>& cracks)
{
  if (cracks.fronts.empty())
    return;
  const auto vertex = onHost(cracks.vertex);
  const auto simplex = onHost(cracks.simplex);
  const auto frontFacet = onHost(cracks.frontFacet);
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
  if constexpr (D == 3)
  {
    const FrontNodeFrames frames(cracks);
    for (CrackFront<3>& front : cracks.fronts)
      if (!front.ended)
        frames.update(front);
  }
  else
    for (CrackFront<2>& front : cracks.fronts)
    {
      FrontNode<2>& node = front.nodes[0];
      node.vertex = front.vertex;
      node.position = front.position;
      node.direction = front.direction;
      node.normal = front.normal;
    }
}

template void updateNormals(const CrackSet<2>&);
template void updateNormals(const CrackSet<3>&);
template void updateFronts(CrackSet<2>&);
template void updateFronts(CrackSet<3>&);

} // namespace Rhegma::cracks
