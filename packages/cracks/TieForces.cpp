/// Forces and energies of the ties behind fronts, and how they stretch.

#include "cracks/FrontTies.hpp"
#include "cracks/HoldingForce.hpp"
#include "parallel/Subdomain.hpp"
#include "state/FewItems.hpp"

#include <cmath>

namespace Rhegma::cracks
{

namespace
{

/// Force of a tie on its node's own field along an axis [N]. \param cohesive rows of cohesion, or none
/// \param sign of the node's side
template <int D>
KOKKOS_INLINE_FUNCTION double pullOf(const View<double * [D + 1]>& tie, const View<double* [D]>& jump,
                                     const View<double * [D + 4]>& cohesive, int own, int axis, double sign)
{
  const bool shifted = cohesive.extent(0) > 0 && cohesive(own, cohesion::peak) > 0.0;
  const double from = shifted ? cohesive(own, cohesion::shift + axis) : 0.0;
  return -sign * tie(own, D) * (jump(own, axis) + from);
}

} // namespace

template <int D>
void FrontTies<D>::addForces(State<D>& state) const
{
  const Nodes<D> nodes = state.nodes;
  const View<int*> side = state.cracks.nodeSide;
  const View<double* [D]> jump = memory_.jump();
  const View<double * [D + 1]> tie = state.cracks.tie;
  const View<double * [D + 4]> cohesive = memory_.cohesion();
  forFew(
      "rhegma::cracks::tie", nodes.numSecond, KOKKOS_LAMBDA(const int i) {
        const int own = nodes.parent(i), other = nodes.numLattice + i;
        for (int d = 0; d < D; ++d)
        {
          tie(own, d) = pullOf<D>(tie, jump, cohesive, own, d, signOf(side(own)));
          if (!countsHere(nodes, own))
            continue;
          nodes.sums(own, Nodes<D>::forceAt + d) += tie(own, d);
          nodes.sums(other, Nodes<D>::forceAt + d) -= tie(own, d);
        }
      });
}

template <int D>
FollowingForce<D> FrontTies<D>::following() const
{
  using Values = View<double* [D]>;
  const auto frozen = [](const State<D>& state, const NodeSlots& slots, const Values& force)
  {
    const Nodes<D> nodes = state.nodes;
    const View<double * [D + 1]> tie = state.cracks.tie;
    Kokkos::parallel_for(
        "rhegma::cracks::frozenTies", Kokkos::RangePolicy<ExecSpace>(0, nodes.numSecond),
        KOKKOS_LAMBDA(const int i) {
          const int own = nodes.parent(i), other = nodes.numLattice + i;
          if (slots.moves(own) == slots.moves(other) || !countsHere(nodes, own))
            return;
          const int at = slots.of(slots.moves(own) ? own : other);
          for (int d = 0; d < D; ++d)
            force(at, d) += slots.moves(own) ? tie(own, d) : -tie(own, d);
        });
  };
  const auto change =
      [this](const State<D>& state, const NodeSlots& slots, const Values& displacement, const Values& force)
  {
    const Nodes<D> nodes = state.nodes;
    const View<double * [D + 1]> tie = state.cracks.tie;
    const View<int*> side = state.cracks.nodeSide;
    const View<double* [D]> jump = memory_.jump();
    const View<double * [D + 4]> cohesive = memory_.cohesion();
    const bool grows = grows_;
    Kokkos::parallel_for(
        "rhegma::cracks::followTies", Kokkos::RangePolicy<ExecSpace>(0, nodes.numSecond),
        KOKKOS_LAMBDA(const int i) {
          const int own = nodes.parent(i), other = nodes.numLattice + i;
          if (tie(own, D) == 0.0 || !slots.moves(own) || !slots.moves(other) || !countsHere(nodes, own))
            return;
          const int a = slots.of(own), b = slots.of(other);
          const double sign = signOf(side(own));
          const bool resists = grows && cohesive(own, cohesion::peak) > 0.0;
          double from[D], square = 0.0;
          for (int d = 0; d < D; ++d)
          {
            from[d] = jump(own, d) + sign * (displacement(a, d) - displacement(b, d)) +
                      (resists ? cohesive(own, cohesion::shift + d) : 0.0);
            square += from[d] * from[d];
          }
          double stiffness = tie(own, D);
          if (resists && square > cohesive(own, cohesion::reached) * cohesive(own, cohesion::reached))
            stiffness = std::fmin(stiffness, cohesion::secantAt(cohesive, own, std::sqrt(square)));
          for (int d = 0; d < D; ++d)
          {
            const double more = -sign * stiffness * from[d] - tie(own, d);
            force(a, d) += more;
            force(b, d) -= more;
          }
        });
  };
  return {frozen, change};
}

template <int D>
void FrontTies<D>::advance(State<D>& state)
{
  const Nodes<D> nodes = state.nodes;
  const View<int*> side = state.cracks.nodeSide;
  const View<double* [D]> jump = memory_.jump();
  const View<double * [D + 1]> tie = state.cracks.tie;
  const View<double * [D + 4]> cohesive = memory_.cohesion();
  const bool grows = grows_;
  const double dt = state.dt;
  const bool byMotion = state.scheme == UpdateScheme::Usl;
  double elastic = 0.0, spent = 0.0;
  sumFew(
      "rhegma::cracks::stretchTies", 0, nodes.numSecond,
      KOKKOS_LAMBDA(const int i, double& sum, double& work) {
        const int own = nodes.parent(i), other = nodes.numLattice + i;
        const double sign = signOf(side(own));
        // A field without mass moves nowhere: beside it the other's flight is no stretch.
        const bool both =
            nodes.sums(own, Nodes<D>::massAt) > 0.0 && nodes.sums(other, Nodes<D>::massAt) > 0.0;
        const bool resists = grows && cohesive(own, cohesion::peak) > 0.0;
        double square = 0.0, more[D];
        for (int d = 0; d < D; ++d)
        {
          const double moved = byMotion ? nodes.motion(own, d) - nodes.motion(other, d)
                                        : nodes.projection(own, d) - nodes.projection(other, d);
          more[d] = both ? sign * dt * moved : -jump(own, d);
          jump(own, d) += more[d];
          if (resists)
          {
            const double from = jump(own, d) + cohesive(own, cohesion::shift + d);
            square += from * from;
          }
          else if (countsHere(nodes, own))
            sum += 0.5 * tie(own, D) * jump(own, d) * jump(own, d);
        }
        if (resists && square > cohesive(own, cohesion::reached) * cohesive(own, cohesion::reached))
        {
          cohesive(own, cohesion::reached) = std::sqrt(square);
          const double now = cohesion::secant(cohesive, own);
          tie(own, D) = now < tie(own, D) ? now : tie(own, D);
        }
        for (int d = 0; d < D; ++d)
        {
          const double before = tie(own, d);
          tie(own, d) = pullOf<D>(tie, jump, cohesive, own, d, sign);
          if (resists && both && countsHere(nodes, own))
            work -= 0.5 * sign * (before + tie(own, d)) * more[d];
        }
      },
      elastic, spent);
  state.energy.ties = elastic;
  state.energy.fracture += spent;
}

template <int D>
double FrontTies<D>::energyInFlight(const State<D>& state, int step) const
{
  const Nodes<D> nodes = state.nodes;
  const View<double* [D]> jump = memory_.jump();
  const View<int*> last = memory_.step();
  const View<double * [D + 4]> cohesive = memory_.cohesion();
  double sum = sumFew<double>(
      "rhegma::cracks::energyInFlight", static_cast<int>(cohesive.extent(0)),
      KOKKOS_LAMBDA(const int n, double& all) {
        if (last(n) != step || step == 0 || !(cohesive(n, cohesion::peak) > 0.0) || !countsHere(nodes, n))
          return;
        const double r = cohesive(n, cohesion::reached), force = cohesion::strength(cohesive, n);
        double square = 0.0;
        for (int d = 0; d < D; ++d)
        {
          const double from = jump(n, d) + cohesive(n, cohesion::shift + d);
          square += from * from;
        }
        const double end = cohesive(n, cohesion::start) + cohesive(n, cohesion::range);
        if (force > 0.0)
          all += 0.5 * force * (end - r) + 0.5 * force / r * (r * r - square);
      });
  sumParts(state, &sum, 1);
  for (const CrackFront<D>& front : state.cracks.fronts)
    sum += front.unspent;
  return sum;
}

template void FrontTies<2>::addForces(State<2>&) const;
template void FrontTies<3>::addForces(State<3>&) const;
template FollowingForce<2> FrontTies<2>::following() const;
template FollowingForce<3> FrontTies<3>::following() const;
template void FrontTies<2>::advance(State<2>&);
template void FrontTies<3>::advance(State<3>&);
template double FrontTies<2>::energyInFlight(const State<2>&, int) const;
template double FrontTies<3>::energyInFlight(const State<3>&, int) const;

} // namespace Rhegma::cracks
