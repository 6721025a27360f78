#include "combustion/Cavity.hpp"

#include "base/ReadList.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace Rhegma::combustion
{

namespace
{

/// Calls surface-breaking end(vertices of the facet) for each facet of the crack beyond which there is the
/// surface of the body (facet::surfaceBreaking) or another crack (facet::joined).
template <int D, class SurfaceEnd>
void forEachSurfaceEnd(const State<D>& state, int crack, int beyond, const std::vector<MirrorPlane>& mirrors,
                       const SurfaceEnd& surfaceEnd)
{
  const CrackSet<D>& cracks = state.cracks;
  const auto vertex = onHost(cracks.vertex);
  const auto simplex = onHost(cracks.simplex);
  const auto neighbour = onHost(cracks.neighbour);
  const Crack<D>& c = cracks.cracks[crack];
  for (int s = c.firstSimplex; s < c.firstSimplex + c.numSimplices; ++s)
    for (int i = 0; i < D; ++i)
    {
      if (neighbour(s, i) != beyond)
        continue;
      int corner[D - 1];
      for (int k = 0; k < D - 1; ++k)
        corner[k] = simplex(s, (i + 1 + k) % D);
      const bool mirrored = std::any_of(
          mirrors.begin(), mirrors.end(),
          [&](const MirrorPlane& plane)
          {
            return std::all_of(std::begin(corner), std::end(corner),
                               [&](int v)
                               { return isOn(plane, vertex(v, plane.axis), state.mesh.smallestSpacing()); });
          });
      if (!mirrored)
        surfaceEnd(corner);
    }
}

/// Area of the openings at the first and the last end of a crack [m2].
template <int D>
std::array<double, 2> endAreas(const State<D>& state, int crack, int beyond,
                               const std::vector<MirrorPlane>& mirrors)
{
  const CrackSet<D>& cracks = state.cracks;
  const auto vertex = onHost(cracks.vertex);
  const auto face = onHost(cracks.face);
  const auto normal = onHost(cracks.vertexNormal);
  const int first = cracks.cracks[crack].firstVertex;
  std::array<double, 2> area{};
  forEachSurfaceEnd(state, crack, beyond, mirrors,
                    [&](const int(&corner)[D - 1])
                    {
                      double opening = 0.0, square = 0.0;
                      for (const int v : corner)
                        for (int d = 0; d < D; ++d)
                        {
                          opening += normal(v, d) * (face(v, 1, d) - face(v, 0, d)) / (D - 1);
                          square +=
                              (vertex(v, d) - vertex(corner[0], d)) * (vertex(v, d) - vertex(corner[0], d));
                        }
                      area[corner[0] == first ? 0 : 1] +=
                          std::max(opening, 0.0) * (D == 2 ? state.method.thickness : std::sqrt(square));
                    });
  return area;
}

} // namespace

template <int D>
Cavity measureCavity(const State<D>& state, const FacePoints<D>& points, int crack, const View<int*>& lit)
{
  const View<int*> of = points.crack, acts = points.acts;
  const View<double*> size = points.currentSize, separation = points.separation;
  const double thickness = state.method.thickness;
  Cavity cavity;
  Kokkos::parallel_reduce(
      "rhegma::combustion::measureCavity", Kokkos::RangePolicy<ExecSpace>(0, points.count()),
      KOKKOS_LAMBDA(const int k, double& area, double& burning, double& felt, double& widest) {
        if (of(k) != crack)
          return;
        const double own = size(k) * thickness;
        area += own;
        felt += acts(k) != 0 ? own : 0.0;
        burning += acts(k) != 0 && lit(k) != 0 ? 2.0 * own : 0.0;
        widest = separation(k) > widest ? separation(k) : widest;
      },
      cavity.area, cavity.burning, cavity.felt, Kokkos::Max<double>(cavity.widest));
  return cavity;
}

template <int D>
std::array<double, 2> surfaceEndAreas(const State<D>& state, int crack,
                                      const std::vector<MirrorPlane>& mirrors)
{
  return endAreas(state, crack, facet::surfaceBreaking, mirrors);
}

template <int D>
std::array<double, 2> joinedAreas(const State<D>& state, int crack)
{
  return endAreas(state, crack, facet::joined, {});
}

template <int D>
double surfaceEndArea(const State<D>& state, int crack, const std::vector<MirrorPlane>& mirrors)
{
  const std::array<double, 2> ends = surfaceEndAreas(state, crack, mirrors);
  return ends[0] + ends[1];
}

template <int D>
bool hasSurfaceEnd(const State<D>& state, int crack, const std::vector<MirrorPlane>& mirrors)
{
  bool any = false;
  forEachSurfaceEnd(state, crack, facet::surfaceBreaking, mirrors, [&](const int(&)[D - 1]) { any = true; });
  return any;
}

template <int D>
double distanceFromCrack(const CrackSet<D>& cracks, int crack, const Vector<D>& lower, const Vector<D>& upper)
{
  const auto vertex = onHost(cracks.vertex);
  const auto simplex = onHost(cracks.simplex);
  const Crack<D>& c = cracks.cracks[crack];
  double least = std::numeric_limits<double>::max();
  // Sampled at positions a tenth of an edge apart in each simplex.
  constexpr int cuts = 10;
  for (int s = c.firstSimplex; s < c.firstSimplex + c.numSimplices; ++s)
    for (int i = 0; i <= cuts; ++i)
      for (int j = 0; j <= (D == 3 ? cuts - i : 0); ++j)
      {
        const double weight[3] = {double(i) / cuts, D == 3 ? double(j) / cuts : 1.0 - double(i) / cuts,
                                  1.0 - double(i + j) / cuts};
        double square = 0.0;
        for (int d = 0; d < D; ++d)
        {
          double x = 0.0;
          for (int k = 0; k < D; ++k)
            x += weight[k] * vertex(simplex(s, k), d);
          const double out = std::max({lower[d] - x, x - upper[d], 0.0});
          square += out * out;
        }
        least = std::min(least, std::sqrt(square));
      }
  return least;
}

template Cavity measureCavity(const State<2>&, const FacePoints<2>&, int, const View<int*>&);
template Cavity measureCavity(const State<3>&, const FacePoints<3>&, int, const View<int*>&);
template double surfaceEndArea(const State<2>&, int, const std::vector<MirrorPlane>&);
template double surfaceEndArea(const State<3>&, int, const std::vector<MirrorPlane>&);
template std::array<double, 2> surfaceEndAreas(const State<2>&, int, const std::vector<MirrorPlane>&);
template std::array<double, 2> surfaceEndAreas(const State<3>&, int, const std::vector<MirrorPlane>&);
template bool hasSurfaceEnd(const State<2>&, int, const std::vector<MirrorPlane>&);
template bool hasSurfaceEnd(const State<3>&, int, const std::vector<MirrorPlane>&);
template std::array<double, 2> joinedAreas(const State<2>&, int);
template std::array<double, 2> joinedAreas(const State<3>&, int);
template double distanceFromCrack(const CrackSet<2>&, int, const Vector<2>&, const Vector<2>&);
template double distanceFromCrack(const CrackSet<3>&, int, const Vector<3>&, const Vector<3>&);

} // namespace Rhegma::combustion
