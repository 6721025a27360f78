/// Nodes that a front has left again.

#include "cracks/Cohesion.hpp"
#include "cracks/FrontTies.hpp"
#include "state/State.hpp"
#include "state/Subdomain.hpp"

namespace Rhegma::cracks
{

namespace
{

/// The front that has grown and is nearest to a place, of whichever crack: a node that is whole again may see
/// none. \param fronts as NearestFront's
KOKKOS_INLINE_FUNCTION int nearestOfAll(const View<double* [4]>& fronts, const Vector<3>& x)
{
  int found = -1;
  double least = 1e300;
  for (int f = 0; f < static_cast<int>(fronts.extent(0)); ++f)
  {
    double square = 0.0;
    for (int d = 0; d < 3; ++d)
      square += (x[d] - fronts(f, d)) * (x[d] - fronts(f, d));
    if (fronts(f, 3) > 0.0 && square < least)
    {
      least = square;
      found = f;
    }
  }
  return found;
}

} // namespace

void giveBack(State<3>& state, const TieMemory<3>& memory, const View<double* [4]>& fronts, int stamp)
{
  const Nodes<3> nodes = state.mesh.nodes;
  const NodePlaces<3> places = nodePlaces(state);
  const View<int*>& last = memory.step();
  const View<double* [3]>& jump = memory.jump();
  const View<double* [7]>& cohesive = memory.cohesion();
  const int before = stamp - 1;
  const auto left = KOKKOS_LAMBDA(const int i)
  {
    const int n = nodes.active(i);
    if (before == 0 || last(n) != before || !(cohesive(n, cohesion::peak) > 0.0) || !countsHere(nodes, n))
      return 0.0;
    double square = 0.0;
    for (int d = 0; d < 3; ++d)
    {
      const double from = jump(n, d) + cohesive(n, cohesion::shift + d);
      square += from * from;
    }
    return cohesion::yetToTake(cohesive, n, square);
  };
  const Kokkos::RangePolicy<ExecSpace> all(0, nodes.active.extent(0));
  double any = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::cracks::whatWholeNodesLeave", all, KOKKOS_LAMBDA(const int i, double& sum) { sum += left(i); },
      any);
  sumParts(state, &any, 1);
  if (!(any > 0.0))
    return;
  for (std::size_t f = 0; f < state.cracks.fronts.size(); ++f)
  {
    double own = 0.0;
    const int front = static_cast<int>(f);
    Kokkos::parallel_reduce(
        "rhegma::cracks::whatWholeNodesLeaveAFront", all,
        KOKKOS_LAMBDA(const int i, double& sum) {
          const double energy = left(i);
          if (energy > 0.0 && nearestOfAll(fronts, places(nodes.active(i))) == front)
            sum += energy;
        },
        own);
    sumParts(state, &own, 1);
    state.cracks.fronts[f].unspent += own;
  }
  // Once: they may be asked again before another node gets two fields.
  Kokkos::parallel_for(
      "rhegma::cracks::forgetWholeNodes", all, KOKKOS_LAMBDA(const int i) {
        const int n = nodes.active(i);
        if (last(n) == before)
          cohesive(n, cohesion::peak) = 0.0;
      });
}

} // namespace Rhegma::cracks
