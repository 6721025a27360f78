/// The cohesive forces of nodes that fronts have passed.

#include "base/FewItems.hpp"
#include "cracks/FrontTies.hpp"
#include "cracks/HoldingForce.hpp"
#include "cracks/SurfaceRelease.hpp"
#include "state/Subdomain.hpp"
#include "transfer/LocalSpacing.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::cracks
{

namespace
{

/// The forces on nodes and second fields, before the solve adds up those of shared nodes; nothing where there
/// is one rank. Collective.
template <int D>
View<double* [D]> forcesOfAllRanks(const State<D>& state)
{
  if (!state.mesh.subdomain)
    return {};
  View<double* [D]> whole("rhegma::cracks::forcesOfAllRanks", state.mesh.nodes.sums.extent(0));
  const auto sums = state.mesh.nodes.sums;
  Kokkos::parallel_for(
      "rhegma::cracks::forcesOfAllRanks", Kokkos::RangePolicy<ExecSpace>(0, whole.extent(0)),
      KOKKOS_LAMBDA(const int n) {
        for (int d = 0; d < D; ++d)
          whole(n, d) = sums(n, Nodes<D>::forceAt + d);
      });
  sumOverRanks(state, whole.data(), D, 0, D);
  return whole;
}

} // namespace

template <int D>
void FrontTies<D>::release(State<D>& state, const Surroundings& surroundings)
{
  double waiting = waiting_;
  maxParts(state, &waiting, 1);
  if (waiting == 0.0)
    return;
  const View<double* [D]> whole = forcesOfAllRanks(state);
  if constexpr (D == 3)
  {
    releaseBehind(*surface_, state, surroundings, whole, memory_.jump(), memory_.cohesion());
    waiting_ = 0;
    return;
  }
  const Nodes<D> nodes = state.mesh.nodes;
  const View<int*> side = state.cracks.nodeSide;
  const View<double*[D]> jump = memory_.jump(), normal = state.cracks.normal;
  const View<std::uint64_t*> nearest = surroundings.nearest;
  const View<double * [D + 1]> tie = state.cracks.tie;
  const View<double * [D + 4]> cohesive = memory_.cohesion();
  const HoldingForce<D> holding{nodes, side, normal, nearest, whole};
  const bool refined = state.mesh.tree.refined();
  const View<int*> level = state.mesh.tree.nodeLevel;
  const int firstShort = firstOfShortSteps(state);
  const double limit = stable / (state.clock.dt * state.clock.dt);
  for (std::size_t f = 0; f < state.cracks.fronts.size(); ++f)
  {
    CrackFront<D>& front = state.cracks.fronts[f];
    const double name = -1.0 - static_cast<double>(f);
    auto sum = sumFew<double>(
        "rhegma::cracks::sumHoldingForces", nodes.numSecond, KOKKOS_LAMBDA(const int i, double& all) {
          const int own = nodes.parent(i);
          if (cohesive(own, cohesion::peak) == name && countsHere(nodes, own))
            all += norm(holding(i));
        });
    sumParts(state, &sum, 1);
    // A node that the front passes by drifting through the cells takes what a cell of new face would: by the
    // toughness of its last advance, and not by what drives it, which may be far above that.
    const double known = f < toughness_.size() ? toughness_[f] : 0.0;
    const double energy = front.unspent > 0.0
                              ? front.unspent
                              : known * state.method.thickness * spacingAt(state, front.position);

    const double owed = f < debt_.size() ? std::min(debt_[f], cohesion::repayment * energy) : 0.0;
    const double torn = f < torn_.size() ? std::min(torn_[f], cohesion::deduction * (energy - owed)) : 0.0;
    const double range = sum > 0.0 ? 2.0 * (energy - owed - torn) / (cohesion::strengthAtFirst * sum) : 0.0;
    if (range > 0.0)
      front.unspent = 0.0;
    if (range > 0.0 && owed > 0.0)
      debt_[f] -= owed;
    if (range > 0.0 && torn > 0.0)
      torn_[f] -= torn;
    forFew(
        "rhegma::cracks::release", nodes.numSecond, KOKKOS_LAMBDA(const int i) {
          const int own = nodes.parent(i), other = nodes.numLattice + i;
          if (cohesive(own, cohesion::peak) != name)
            return;
          const Vector<D> held = holding(i);
          const double a = nodes.sums(own, Nodes<D>::massAt), b = nodes.sums(other, Nodes<D>::massAt);
          const int halvings = refined && level(own) >= firstShort ? level(own) - firstShort + 1 : 0;
          const double stiffness = std::ldexp(limit, 2 * halvings) * a * b / (a + b);
          cohesive(own, cohesion::peak) = 0.0;
          if (!(norm(held) > 0.0) || !(range > 0.0))
            return;
          const double share = cohesion::shareAtFirst(range, norm(held) / stiffness);
          const Vector<D> force = share * held;
          const double size = norm(force);
          cohesive(own, cohesion::peak) = size;
          cohesive(own, cohesion::range) = range * cohesion::strengthAtFirst / share;
          cohesive(own, cohesion::start) = cohesive(own, cohesion::reached) = size / stiffness;
          tie(own, D) = stiffness;
          for (int d = 0; d < D; ++d)
          {
            cohesive(own, cohesion::shift + d) = force[d] / stiffness - jump(own, d);
            tie(own, d) = -signOf(side(own)) * force[d];
            if (!countsHere(nodes, own))
              continue;
            nodes.sums(own, Nodes<D>::forceAt + d) += tie(own, d);
            nodes.sums(other, Nodes<D>::forceAt + d) -= tie(own, d);
          }
        });
  }
  waiting_ = 0;
}

template void FrontTies<2>::release(State<2>&, const Surroundings&);
template void FrontTies<3>::release(State<3>&, const Surroundings&);

} // namespace Rhegma::cracks
