/// Forces and energies of the ties behind fronts, and how they stretch.

#include "base/FewItems.hpp"
#include "cracks/FrontTies.hpp"
#include "cracks/HoldingForce.hpp"
#include "cracks/NearestFront.hpp"
#include "state/Subdomain.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

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

/// What the nodes at each front took beyond their energy on this rank [J]. \param of each node with two
/// fields
template <int D>
std::vector<double> tornAtFronts(const State<D>& state, const NearestFront<D>& frontOf,
                                 const View<double*>& of)
{
  const Nodes<D> nodes = state.mesh.nodes;
  const NodePlaces<D> places = nodePlaces(state);
  const View<int*> side = state.cracks.nodeSide;
  std::vector<double> torn(state.cracks.fronts.size(), 0.0);
  for (std::size_t f = 0; f < torn.size(); ++f)
    torn[f] = sumFew<double>(
        "rhegma::cracks::tornFaces", nodes.numSecond, KOKKOS_LAMBDA(const int i, double& sum) {
          const int own = nodes.parent(i), crack = (side(own) > 0 ? side(own) : -side(own)) - 1;
          if (of(i) > 0.0 && frontOf(places(own), crack) == static_cast<int>(f))
            sum += of(i);
        });
  return torn;
}

} // namespace

template <int D>
void FrontTies<D>::deduct(State<D>& state, std::vector<double> torn)
{
  std::vector<CrackFront<D>>& fronts = state.cracks.fronts;
  sumParts(state, torn.data(), static_cast<int>(torn.size()));
  torn_.resize(fronts.size(), 0.0);
  for (std::size_t f = 0; f < fronts.size(); ++f)
    if constexpr (D == 2)
      torn_[f] += torn[f];
    else
      fronts[f].unspent -= torn[f];
}

template <int D>
void FrontTies<D>::addForces(State<D>& state) const
{
  const Nodes<D> nodes = state.mesh.nodes;
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
    const Nodes<D> nodes = state.mesh.nodes;
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
    const Nodes<D> nodes = state.mesh.nodes;
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
  const Nodes<D> nodes = state.mesh.nodes;
  const View<int*> side = state.cracks.nodeSide;
  const View<double* [D]> jump = memory_.jump();
  const View<double * [D + 1]> tie = state.cracks.tie;
  const View<double * [D + 4]> cohesive = memory_.cohesion();
  const bool grows = grows_;
  const double dt = state.clock.strainPass.share * state.clock.dt;
  const bool byMotion = state.method.scheme == UpdateScheme::Usl, early = state.clock.strainPass.before;
  double elastic = 0.0, spent = 0.0, beyond = 0.0;
  const View<double*> torn("rhegma::cracks::torn", grows ? nodes.numSecond : 0);
  sumFew(
      "rhegma::cracks::stretchTies", 0, nodes.numSecond,
      KOKKOS_LAMBDA(const int i, double& sum, double& work, double& tooMuch) {
        const int own = nodes.parent(i), other = nodes.numLattice + i;
        const double sign = signOf(side(own));
        // A field without mass moves nowhere: beside it the other's flight is no stretch.
        const bool both =
            nodes.sums(own, Nodes<D>::massAt) > 0.0 && nodes.sums(other, Nodes<D>::massAt) > 0.0;
        const bool resists = grows && cohesive(own, cohesion::peak) > 0.0;
        double square = 0.0, squareBefore = 0.0, more[D], before[D];
        for (int d = 0; d < D; ++d)
        {
          const double moved = byMotion ? nodes.motion(own, d) - nodes.motion(other, d)
                                        : nodes.projection(own, d) - nodes.projection(other, d);
          more[d] = both ? sign * dt * moved : -jump(own, d);
          if (resists)
          {
            const double from = jump(own, d) + cohesive(own, cohesion::shift + d);
            squareBefore += from * from;
          }
          // Where strain comes first no force is of this step yet, and that of the last is in no checkpoint.
          before[d] = early ? pullOf<D>(tie, jump, cohesive, own, d, sign) : tie(own, d);
          jump(own, d) += more[d];
          if (resists)
          {
            const double from = jump(own, d) + cohesive(own, cohesion::shift + d);
            square += from * from;
          }
          else if (countsHere(nodes, own))
            sum += 0.5 * tie(own, D) * jump(own, d) * jump(own, d);
        }
        const double left = resists ? cohesion::yetToTake(cohesive, own, squareBefore) : 0.0;
        if (resists && square > cohesive(own, cohesion::reached) * cohesive(own, cohesion::reached))
        {
          cohesive(own, cohesion::reached) = std::sqrt(square);
          const double now = cohesion::secant(cohesive, own);
          tie(own, D) = now < tie(own, D) ? now : tie(own, D);
        }
        double taken = 0.0;
        for (int d = 0; d < D; ++d)
        {
          tie(own, d) = pullOf<D>(tie, jump, cohesive, own, d, sign);
          taken -= 0.5 * sign * (before[d] + tie(own, d)) * more[d];
        }
        if (!resists || !both || !countsHere(nodes, own))
          return;
        work += taken;
        const double energy = 0.5 * cohesive(own, cohesion::peak) * cohesive(own, cohesion::range);
        if (left > 0.0 && !(cohesion::strength(cohesive, own) > 0.0) &&
            taken > left + cohesion::tolerated * energy)
          tooMuch += torn(i) = taken - left;
      },
      elastic, spent, beyond);
  const std::vector<CrackFront<D>>& fronts = state.cracks.fronts;
  const bool any = std::any_of(fronts.begin(), fronts.end(), [](const CrackFront<D>& f) { return f.grown; });
  if (grows && any)
    deduct(state, beyond > 0.0 ? tornAtFronts<D>(state, NearestFront<D>{fronts_}, torn)
                               : std::vector<double>(fronts.size(), 0.0));
  state.energy.ties = elastic;
  state.energy.fracture += spent;
}

template <int D>
double FrontTies<D>::energyInFlight(const State<D>& state, int step) const
{
  const Nodes<D> nodes = state.mesh.nodes;
  const View<double* [D]> jump = memory_.jump();
  const View<int*> last = memory_.step();
  const View<double * [D + 4]> cohesive = memory_.cohesion();
  double sum = sumFew<double>(
      "rhegma::cracks::energyInFlight", static_cast<int>(cohesive.extent(0)),
      KOKKOS_LAMBDA(const int n, double& all) {
        if (last(n) != step || step == 0 || !(cohesive(n, cohesion::peak) > 0.0) || !countsHere(nodes, n))
          return;
        double square = 0.0;
        for (int d = 0; d < D; ++d)
        {
          const double from = jump(n, d) + cohesive(n, cohesion::shift + d);
          square += from * from;
        }
        all += cohesion::yetToTake(cohesive, n, square);
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
