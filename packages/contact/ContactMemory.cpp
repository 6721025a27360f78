/// What contact remembers: at its points where these are placed anew, and in checkpoints.

#include "archive/Archive.hpp"
#include "base/RowOrder.hpp"
#include "contact/FaceContact.hpp"

#include <string>
#include <vector>

namespace Rhegma::contact
{

namespace
{

/// Heat by size of points that were placed anew [J/m2]: what each earlier point had goes to the points that
/// inherit from it by their sizes, or where none does to the one in its place. \param size of earlier points
template <int D>
View<double*> leaveHeat(const View<double*>& old, const View<double*>& size, const FacePoints<D>& points)
{
  View<double*> fresh("rhegma::contactHeat", points.count());
  const auto heat = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, old);
  const auto oldSize = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, size);
  const auto newSize = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, points.size);
  const auto before = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, points.before);
  const auto after = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, points.after);
  const auto host = Kokkos::create_mirror_view(fresh);
  const int count = static_cast<int>(heat.extent(0));
  std::vector<double> heirs(count, 0.0); // their size
  for (int k = 0; k < points.count(); ++k)
    if (before(k) >= 0)
      heirs[before(k)] += newSize(k);
  for (int k = 0; k < points.count(); ++k)
    if (before(k) >= 0)
      host(k) = heat(before(k)) * oldSize(before(k)) / heirs[before(k)];
  for (int o = 0; o < count; ++o)
    if (heirs[o] == 0.0 && after(o) >= 0)
      host(after(o)) += heat(o) * oldSize(o) / newSize(after(o));
  Kokkos::deep_copy(fresh, host);
  return fresh;
}

} // namespace

template <int D>
void FaceContact<D>::keepHistory(const View<double*>& size)
{
  gap_ = inOrder(gap_, points_.before);
  slip_ = inOrder(slip_, points_.before);
  pressure_ = inOrder(pressure_, points_.before);
  shear_ = inOrder(shear_, points_.before);
  heat_ = leaveHeat(heat_, size, points_);
}

template <int D>
void FaceContact<D>::keep(Archive& archive)
{
  {
    const Archive::Group group(archive, "points");
    points_.keep(archive);
  }
  archive("gap", gap_);
  archive("slip", slip_);
  archive("pressure", pressure_);
  archive("shear", shear_);
  archive("heat", heat_);
  archive("closed", closed_);
  archive("peak", peak_);
  archive("thickness", thickness_);
  archive("stored", stored_);
  archive("dissipated", dissipated_);
  keepCracks(archive);
}

template <int D>
void FaceContact<D>::keepCracks(Archive& archive)
{
  int cracks = static_cast<int>(cracks_.size());
  archive("cracks", cracks);
  cracks_.resize(cracks);
  if (static_cast<int>(stiffness_.extent(0)) != cracks)
    stiffness_ = View<Stiffness*>("rhegma::contactStiffness", cracks);
  const auto stiffness = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, stiffness_);
  for (int c = 0; c < cracks; ++c)
  {
    const Archive::Group group(archive, "crack " + std::to_string(c));
    archive("stiffness_normal", stiffness(c).normal);
    archive("stiffness_tangential", stiffness(c).tangential);
    archive("closed_points", cracks_[c].closedPoints);
    archive("touches", cracks_[c].touches);
    archive("first_touch", cracks_[c].firstTouch);
    archive("largest_pressure", cracks_[c].largestPressure);
  }
  Kokkos::deep_copy(stiffness_, stiffness);
}

template void FaceContact<2>::keepHistory(const View<double*>&);
template void FaceContact<3>::keepHistory(const View<double*>&);
template void FaceContact<2>::keep(Archive&);
template void FaceContact<3>::keep(Archive&);

} // namespace Rhegma::contact
