#include "contact/ClosedVisibility.hpp"

#include "archive/Archive.hpp"
#include "state/Subdomain.hpp"
#include "transfer/Stencils.hpp"

#include <cmath>

namespace Rhegma::contact
{

namespace
{

KOKKOS_INLINE_FUNCTION void copyRow(const StencilTable<2>& from, const StencilTable<2>& to, int r)
{
  to.count(r) = from.count(r);
  for (int k = 0; k < from.count(r); ++k)
  {
    to.node(r, k) = from.node(r, k);
    to.weight(r, k) = from.weight(r, k);
    for (int d = 0; d < 2; ++d)
      to.slope(r, k, d) = from.slope(r, k, d);
  }
}

void copyRows(const StencilTable<2>& from, const StencilTable<2>& to, int count)
{
  Kokkos::parallel_for(
      "rhegma::contact::copyRows", Kokkos::RangePolicy<ExecSpace>(0, count),
      KOKKOS_LAMBDA(const int r) { copyRow(from, to, r); });
}

/// Gives the points nearest to a closed face point their whole stencil back.
void mendClosed(const ObservedPoints<2>& points, const FacePoints<2>& faces, const View<double*>& separation,
                const StencilTable<2>& whole, const StencilTable<2>& table)
{
  Kokkos::parallel_for(
      "rhegma::contact::mendClosed", Kokkos::RangePolicy<ExecSpace>(0, points.count),
      KOKKOS_LAMBDA(const int r) {
        const int crack = (points.side(r) > 0 ? points.side(r) : -points.side(r)) - 1;
        int nearest = -1;
        double least = 1e300;
        for (int k = 0; k < faces.count(); ++k)
        {
          const double dx = faces.position(k, 0) - points.position(r, 0);
          const double dy = faces.position(k, 1) - points.position(r, 1);
          if (faces.crack(k) == crack && dx * dx + dy * dy < least)
          {
            least = dx * dx + dy * dy;
            nearest = k;
          }
        }
        if (nearest >= 0 && separation(nearest) < 0.0)
          copyRow(whole, table, r);
      });
}

} // namespace

void ClosedVisibility::install(State<2>& state)
{
  StencilEditor<2>& editor = state.stored.editors.front(); // of the cracks
  cut_ = editor.edit;
  editor.keep = nullptr; // faces close and open
  editor.edit = [this](const State<2>& s, const ObservedPoints<2>& points, const StencilTable<2>& table)
  { edit(s, points, table); };
}

void ClosedVisibility::edit(const State<2>& state, const ObservedPoints<2>& points,
                            const StencilTable<2>& table)
{
  if (whole_)
    return;
  kept_.reserve(points.count);
  copyRows(table, kept_, points.count);
  cut_(state, points, table);
  if (points_.count() > 0)
    mendClosed(points, points_, separation_, kept_, table);
}

void ClosedVisibility::prepare(const State<2>& state)
{
  whole_ = true;
  if (points_.update(state))
  {
    separation_ = View<double*>("rhegma::closedSeparation", points_.count());
    reserveRows();
  }
  setAround(state);
  pointStencils(state, behind_, below_, true);
  pointStencils(state, ahead_, above_, true);
  whole_ = false;
}

void ClosedVisibility::reserveRows()
{
  seen_ = View<double*>("rhegma::seenOfFaces", 4 * points_.count());
  for (ObservedPoints<2>* side : {&behind_, &ahead_})
  {
    side->count = points_.count();
    side->onAllRanks = true;
    side->position = View<double* [2]>("rhegma::aroundFacePosition", points_.count());
    side->half = View<double* [2]>("rhegma::aroundFaceHalf", points_.count());
    side->side = View<int*>("rhegma::aroundFaceSide", points_.count());
  }
}

void ClosedVisibility::serialize(Archive& archive)
{
  {
    const Archive::Group group(archive, "points");
    points_.serialize(archive);
  }
  archive("separation", separation_);
  if (archive.loads())
    reserveRows();
}

void ClosedVisibility::setAround(const State<2>& state)
{
  const double cell = state.mesh.grid.spacing;
  const View<double* [2]> normal = state.cracks.normal; // in the cells
  const View<int*> simplex = points_.simplex();
  const FacePoints<2> points = points_;
  const View<double*[2]> behind = behind_.position, ahead = ahead_.position;
  Kokkos::parallel_for(
      "rhegma::contact::setAround", Kokkos::RangePolicy<ExecSpace>(0, points_.count()),
      KOKKOS_LAMBDA(const int k) {
        for (int d = 0; d < 2; ++d)
        {
          behind(k, d) = points.position(k, d) - 0.5 * cell * normal(simplex(k), d);
          ahead(k, d) = points.position(k, d) + 0.5 * cell * normal(simplex(k), d);
        }
      });
}

template <class Velocity>
void ClosedVisibility::advance(const State<2>& state, const Velocity& velocity)
{
  const FacePoints<2> points = points_;
  const StencilTable<2> below = below_, above = above_;
  const View<double*> separation = separation_, seen = seen_;
  const double dt = state.clock.dt;
  // Where the boundary between ranks runs along the crack, the two sides are on different ranks.
  Kokkos::parallel_for(
      "rhegma::contact::seeFaces", Kokkos::RangePolicy<ExecSpace>(0, points_.count()),
      KOKKOS_LAMBDA(const int k) {
        const Vector<2> jump = jumpAt<2>(below, above, k, velocity);
        for (int d = 0; d < 2; ++d)
          seen(4 * k + d) = jump[d];
        seen(4 * k + 2) = below.count(k) > 0 ? 1.0 : 0.0;
        seen(4 * k + 3) = above.count(k) > 0 ? 1.0 : 0.0;
      });
  sumParts(state, seen_);
  Kokkos::parallel_for(
      "rhegma::contact::advanceSeparation", Kokkos::RangePolicy<ExecSpace>(0, points_.count()),
      KOKKOS_LAMBDA(const int k) {
        if (seen(4 * k + 2) == 0.0 || seen(4 * k + 3) == 0.0)
          return;
        const Vector<2> n{points.normal(k, 0), points.normal(k, 1)}, jump{seen(4 * k), seen(4 * k + 1)};
        separation(k) += dt * dot(jump, n);
      });
}

int ClosedVisibility::closedPoints(int crack) const
{
  const View<int*> of = points_.crack;
  const View<double*> separation = separation_;
  int closed = 0;
  Kokkos::parallel_reduce(
      "rhegma::contact::closedPoints", Kokkos::RangePolicy<ExecSpace>(0, points_.count()),
      KOKKOS_LAMBDA(const int k, int& sum) { sum += of(k) == crack && separation(k) < 0.0 ? 1 : 0; }, closed);
  return closed;
}

template void ClosedVisibility::advance(const State<2>&, const View<double * [Nodes<2>::motionWidth]>&);
template void ClosedVisibility::advance(const State<2>&, const View<double * [Nodes<2>::projectionWidth]>&);

} // namespace Rhegma::contact
