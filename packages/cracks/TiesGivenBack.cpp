/// Nodes that a front has left again.

#include "cracks/Cohesion.hpp"
#include "cracks/FrontTies.hpp"
#include "cracks/Nearest.hpp"
#include "cracks/NearestFront.hpp"
#include "cracks/Sides.hpp"
#include "parallel/Subdomain.hpp"
#include "state/State.hpp"

namespace Rhegma::cracks
{

template <int D>
void FrontTies<D>::giveBack(State<D>& state, const Surroundings& surroundings) const
{
  const Nodes<D> nodes = state.nodes;
  const NodePlaces<D> places = nodePlaces(state);
  const View<int*> last = memory_.step();
  const View<double* [D]> jump = memory_.jump();
  const View<double * [D + 4]> cohesive = memory_.cohesion();
  const View<std::uint64_t*> nearest = surroundings.nearest;
  const View<int*> crackOf = state.cracks.crackOf;
  const NearestFront<D> frontOf{fronts_};
  const int before = surroundings.stamp - 1, cracks = static_cast<int>(state.cracks.cracks.size());
  for (std::size_t f = 0; f < state.cracks.fronts.size(); ++f)
  {
    double left = 0.0;
    Kokkos::parallel_reduce(
        "rhegma::cracks::giveBack", Kokkos::RangePolicy<ExecSpace>(0, nodes.active.extent(0)),
        KOKKOS_LAMBDA(const int i, double& sum) {
          const int n = nodes.active(i);
          if (before == 0 || last(n) != before || !(cohesive(n, cohesion::peak) > 0.0) ||
              !countsHere(nodes, n))
            return;
          // Where the crack is out of sight now, of the first crack whose front has grown.
          const bool seen = nearest(n) != noSimplex;
          int front = -1;
          for (int c = seen ? crackOf(simplexOf(nearest(n))) : 0; c < cracks && front < 0; ++c)
          {
            front = frontOf(places(n), c);
            if (seen)
              break;
          }
          if (front != static_cast<int>(f))
            return;
          double square = 0.0;
          for (int d = 0; d < D; ++d)
          {
            const double from = jump(n, d) + cohesive(n, cohesion::shift + d);
            square += from * from;
          }
          sum += cohesion::yetToTake(cohesive, n, square);
        },
        left);
    sumParts(state, &left, 1);
    state.cracks.fronts[f].unspent += left;
  }
}

template void FrontTies<2>::giveBack(State<2>&, const Surroundings&) const;
template void FrontTies<3>::giveBack(State<3>&, const Surroundings&) const;

} // namespace Rhegma::cracks
