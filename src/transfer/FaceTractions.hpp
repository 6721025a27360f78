#pragma once
/// Tractions at points on the faces of cracks, as contact and cohesion have them.

#include "state/Subdomain.hpp"
#include "transfer/FacePoints.hpp"
#include "transfer/PushNodes.hpp"

#include <string>
#include <vector>

namespace Rhegma
{

/// Traction on side +1 at a point [Pa]. \param pressure that presses the faces together \param shear that
/// holds back side +1, along the tangents
template <int D>
KOKKOS_INLINE_FUNCTION Vector<D> tractionAt(const FacePoints<D>& points, const View<double*>& pressure,
                                            const View<double * [D - 1]>& shear, int k)
{
  Vector<D> traction;
  for (int d = 0; d < D; ++d)
    traction[d] = pressure(k) * points.normal(k, d);
  for (int t = 0; t < D - 1; ++t)
    traction = traction - shear(k, t) * tangentOf(points, k, t);
  return traction;
}

/// Adds the forces of such tractions to nodes: opposite ones on the two faces, so momentum is kept to
/// round-off. Points without any traction are passed over. \param label of the kernel \param forces for
/// addFaceForces
template <int D, class Forces>
void scatterTractions(const char* label, const Forces& forces, const FacePoints<D>& points,
                      const View<double*>& pressure, const View<double * [D - 1]>& shear, double thickness)
{
  forEachPushing(
      label, points.count(), KOKKOS_LAMBDA(const int k) {
        bool acts = pressure(k) != 0.0;
        for (int t = 0; t < D - 1; ++t)
          acts = acts || shear(k, t) != 0.0;
        if (!acts)
          return;
        const Vector<D> onUpper = (points.size(k) * thickness) * tractionAt(points, pressure, shear, k);
        addFaceForces<D>(forces, points.below, points.above, k, onUpper);
      });
}

/// Jumps of a nodal velocity (first D columns) from side -1 to side +1 at all points, on all ranks.
/// Collective. \param label of the kernel \param jumps D numbers a point; gets its size
template <int D, class Velocity>
void findFaceJumps(const char* label, const State<D>& state, const FacePoints<D>& points,
                   const Velocity& velocity, View<double*>& jumps)
{
  if (static_cast<int>(jumps.extent(0)) != D * points.count())
    jumps = View<double*>("rhegma::faceJumps", D * points.count());
  const View<double*> all = jumps;
  Kokkos::parallel_for(
      label, Kokkos::RangePolicy<ExecSpace>(0, points.count()), KOKKOS_LAMBDA(const int k) {
        const Vector<D> jump = jumpAt<D>(points.below, points.above, k, velocity);
        for (int d = 0; d < D; ++d)
          all(D * k + d) = jump[d];
      });
  sumParts(state, jumps);
}

/// A quantity per size of replaced points whose total is kept: that of each earlier point goes to the points
/// that inherit from it, by their sizes, or where there is none to the point at its position. \param label of
/// the view \param size of earlier points [m, m2]
template <int D>
View<double*> inheritBySize(const std::string& label, const View<double*>& old, const View<double*>& size,
                            const FacePoints<D>& points)
{
  View<double*> fresh(label, points.count());
  const auto quantity = onHost(old);
  const auto oldSize = onHost(size);
  const auto newSize = onHost(points.size);
  const auto before = onHost(points.before);
  const auto after = onHost(points.after);
  const auto host = Kokkos::create_mirror_view(fresh);
  const int count = static_cast<int>(quantity.extent(0));
  std::vector<double> heirs(count, 0.0); // their size
  for (int k = 0; k < points.count(); ++k)
    if (before(k) >= 0)
      heirs[before(k)] += newSize(k);
  for (int k = 0; k < points.count(); ++k)
    if (before(k) >= 0)
      host(k) = quantity(before(k)) * oldSize(before(k)) / heirs[before(k)];
  for (int o = 0; o < count; ++o)
    if (heirs[o] == 0.0 && after(o) >= 0)
      host(after(o)) += quantity(o) * oldSize(o) / newSize(after(o));
  Kokkos::deep_copy(fresh, host);
  return fresh;
}

} // namespace Rhegma
