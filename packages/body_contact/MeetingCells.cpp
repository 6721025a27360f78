#include "body_contact/MeetingCells.hpp"

#include "body_contact/NearBlocks.hpp"
#include "state/BodyGroup.hpp"

namespace Rhegma::body_contact
{

namespace
{

constexpr int lowestOfNone = 1 << 30;

template <int D>
void reserveCells(const State<D>& state, MeetingCells& cells)
{
  if (static_cast<int>(cells.meets.extent(0)) >= state.mesh.nodes.numLattice)
    return;
  const int nodes = state.mesh.nodes.numLattice;
  cells.own = View<int* [2]>("rhegma::groupsOfCells", nodes);
  cells.around = View<int* [2]>("rhegma::groupsAroundCells", nodes);
  cells.next = View<int* [2]>("rhegma::groupsNextToCells", nodes);
  cells.meets = View<char*>("rhegma::meetingCells", nodes);
  for (const View<int* [2]>& range : {cells.own, cells.around, cells.next})
    Kokkos::deep_copy(Kokkos::subview(range, Kokkos::ALL, 0), lowestOfNone);
}

/// Widens the ranges of cells along an axis. \param reach [cells]
template <int D>
void widen(const State<D>& state, const View<int* [2]>& from, const View<int* [2]>& to, int axis, int reach)
{
  const Nodes<D> nodes = state.mesh.nodes;
  const int stride = state.mesh.grid.stride[axis], end = static_cast<int>(from.extent(0));
  Kokkos::parallel_for(
      "rhegma::widenMeetingCells", Kokkos::RangePolicy<ExecSpace>(0, nodes.active.extent(0)),
      KOKKOS_LAMBDA(const int i) {
        const int n = nodes.active(i);
        int lowest = lowestOfNone, highest = 0;
        for (int k = -reach; k <= reach; ++k)
        {
          // Beyond the end of a row is the next one: a cell too many is looked at, never one too few.
          const int other = n + k * stride;
          if (other < 0 || other >= end)
            continue;
          lowest = from(other, 0) < lowest ? from(other, 0) : lowest;
          highest = from(other, 1) > highest ? from(other, 1) : highest;
        }
        to(n, 0) = lowest;
        to(n, 1) = highest;
      });
}

/// Adds the groups of particles to their cells.
template <int D>
struct AddGroups
{
  Grid<D> grid;
  BorrowedView<double* [D]> position;
  BorrowedView<int*> bodyGroup;
  View<int* [2]> own;

  KOKKOS_INLINE_FUNCTION void operator()(int p) const
  {
    int cell = 0;
    for (int d = 0; d < D; ++d)
      cell += grid.stride[d] * static_cast<int>(grid.inCells(position(p, d), d));
    const int group = bodyGroup(p);
    if (group < own(cell, 0))
      own(cell, 0) = group;
    if (group > own(cell, 1))
      own(cell, 1) = group;
  }
};

} // namespace

template <int D>
void findMeetingCells(const State<D>& state, const View<char*>& nearBlock, MeetingCells& cells)
{
  reserveCells(state, cells);
  const Nodes<D> nodes = state.mesh.nodes;
  const View<int* [2]> own = cells.own;
  Kokkos::parallel_for(
      "rhegma::clearGroupsOfCells", Kokkos::RangePolicy<ExecSpace>(0, nodes.active.extent(0)),
      KOKKOS_LAMBDA(const int i) {
        const int n = nodes.active(i);
        own(n, 0) = lowestOfNone;
        own(n, 1) = 0;
      });
  forEachParticleNear("rhegma::groupsOfCells", state, nearBlock,
                      AddGroups<D>{state.mesh.grid, state.particles.template real<D>(fields::position),
                                   state.particles.integer(fields::bodyGroup), own});
  // Particles in cells c and c + reach have one node in common.
  const int reach = state.method.shape == ShapeKind::Linear ? 1 : 3;
  View<int*[2]> from = own, to = cells.around;
  for (int axis = 0; axis < D; ++axis)
  {
    widen(state, from, to, axis, reach);
    from = to;
    to = axis == 0 ? cells.next : cells.around;
  }
  const View<int* [2]> range = from;
  const View<char*> meets = cells.meets;
  Kokkos::parallel_for(
      "rhegma::markMeetingCells", Kokkos::RangePolicy<ExecSpace>(0, nodes.active.extent(0)),
      KOKKOS_LAMBDA(const int i) {
        const int n = nodes.active(i);
        meets(n) = range(n, 0) < range(n, 1) ? 1 : 0;
      });
}

template void findMeetingCells(const State<2>&, const View<char*>&, MeetingCells&);
template void findMeetingCells(const State<3>&, const View<char*>&, MeetingCells&);

} // namespace Rhegma::body_contact
