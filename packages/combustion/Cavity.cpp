#include "combustion/Cavity.hpp"

#include <algorithm>

namespace Rhegma::combustion
{

namespace
{

/// Calls mouth(vertices of the facet) for each facet of the crack at the surface of the body.
template <int D, class Mouth>
void forEachMouth(const CrackSet<D>& cracks, int crack, const Mouth& mouth)
{
  const auto simplex = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, cracks.simplex);
  const auto neighbour = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, cracks.neighbour);
  const Crack<D>& c = cracks.cracks[crack];
  for (int s = c.firstSimplex; s < c.firstSimplex + c.numSimplices; ++s)
    for (int i = 0; i < D; ++i)
    {
      if (neighbour(s, i) != facet::mouth)
        continue;
      int corner[D - 1];
      for (int k = 0; k < D - 1; ++k)
        corner[k] = simplex(s, (i + 1 + k) % D);
      mouth(corner);
    }
}

} // namespace

template <int D>
Cavity measureCavity(const State<D>& state, const FacePoints<D>& points, int crack, const Flame<D>& flame)
{
  const FacePoints<D> p = points;
  const Flame<D> f = flame;
  const double thickness = state.thickness;
  Cavity cavity;
  Kokkos::parallel_reduce(
      "rhegma::combustion::measureCavity", Kokkos::RangePolicy<ExecSpace>(0, points.count()),
      KOKKOS_LAMBDA(const int k, double& area, double& burning, double& felt) {
        if (p.crack(k) != crack)
          return;
        const double own = p.currentSize(k) * thickness;
        area += own;
        felt += p.acts(k) != 0 ? own : 0.0;
        burning += p.acts(k) != 0 && f.reaches(p, k) ? 2.0 * own : 0.0;
      },
      cavity.area, cavity.burning, cavity.felt);
  return cavity;
}

template <int D>
double mouthArea(const State<D>& state, int crack)
{
  const CrackSet<D>& cracks = state.cracks;
  const auto vertex = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, cracks.vertex);
  const auto face = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, cracks.face);
  const auto normal = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, cracks.vertexNormal);
  double area = 0.0;
  forEachMouth(cracks, crack,
               [&](const int(&corner)[D - 1])
               {
                 double opening = 0.0, square = 0.0;
                 for (const int v : corner)
                   for (int d = 0; d < D; ++d)
                   {
                     opening += normal(v, d) * (face(v, 1, d) - face(v, 0, d)) / (D - 1);
                     square += (vertex(v, d) - vertex(corner[0], d)) * (vertex(v, d) - vertex(corner[0], d));
                   }
                 area += std::max(opening, 0.0) * (D == 2 ? state.thickness : std::sqrt(square));
               });
  return area;
}

template <int D>
bool hasMouth(const CrackSet<D>& cracks, int crack)
{
  bool any = false;
  forEachMouth(cracks, crack, [&](const int(&)[D - 1]) { any = true; });
  return any;
}

template Cavity measureCavity(const State<2>&, const FacePoints<2>&, int, const Flame<2>&);
template Cavity measureCavity(const State<3>&, const FacePoints<3>&, int, const Flame<3>&);
template double mouthArea(const State<2>&, int);
template double mouthArea(const State<3>&, int);
template bool hasMouth(const CrackSet<2>&, int);
template bool hasMouth(const CrackSet<3>&, int);

} // namespace Rhegma::combustion
