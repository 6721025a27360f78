/// Forces and energies of the springs behind fronts, and how they stretch.

#include "base/SmallLoops.hpp"
#include "boundary/LoadVelocity.hpp"
#include "cracks/FrontSprings.hpp"
#include "cracks/HoldingForce.hpp"
#include "cracks/Release.hpp"
#include "state/Subdomain.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace Rhegma::cracks
{

namespace
{

/// Force of a spring on its node's primary field [N]. \param stiffness now [N/m] \param sign of the node's
/// side
template <int D>
KOKKOS_INLINE_FUNCTION Vector<D> pullOf(double stiffness, const Vector<D>& opening, double sign)
{
  return (-sign * stiffness) * opening;
}

template <int D>
KOKKOS_INLINE_FUNCTION Vector<D> forceOf(const View<double * [D + 1]>& spring, int primary)
{
  Vector<D> force;
  for (int d = 0; d < D; ++d)
    force[d] = spring(primary, d);
  return force;
}

/// \param rows of nodes, with D numbers or more
template <class Rows, int D>
KOKKOS_INLINE_FUNCTION void setForce(const Rows& rows, int primary, const Vector<D>& force)
{
  for (int d = 0; d < D; ++d)
    rows(primary, d) = force[d];
}

/// Stretches the spring of the i-th node with two fields over a step.
template <int D>
struct StretchSpring
{
  Nodes<D> nodes;
  NodePositions<D> positions;
  View<int*> side;
  NodalSprings<D> springs;
  View<double * [D + 1]> spring; ///< CrackSet::spring
  View<double*> damping;         ///< [N s/m]
  NearestFront<D> frontOf;
  View<double*> excess; ///< energy that nodes over-dissipated [J]
  View<double*> energy; ///< CrackSet::springEnergy
  double dt;
  bool byMotion; ///< the nodal motion strains the particles, not the projection
  bool early;    ///< before the forces of this step

  /// \param elastic energy of springs \param work dissipated by tractions \param beyond sum of excess [J]
  KOKKOS_INLINE_FUNCTION void operator()(int i, double& elastic, double& work, double& beyond) const
  {
    const int primary = nodes.parent(i), enriched = nodes.numLattice + i;
    const double sign = signOf(side(primary));
    const bool counts = isOwnedByThisRank(nodes, primary);
    // Where one of the two fields has no mass, their relative motion is no stretch.
    const bool both =
        bothHaveMass(nodes.sums(primary, Nodes<D>::massAt), nodes.sums(enriched, Nodes<D>::massAt));
    const NodalSpring<D> node = springs(primary);
    const Vector<D> from = node.opening();
    // Where strain comes first, forces of this step are not known yet, and those of the last are not in
    // checkpoints.
    const Vector<D> before = early ? pullOf(spring(primary, D), from, sign) : forceOf<D>(spring, primary);
    Vector<D> more, rate;
    for (int d = 0; d < D; ++d)
    {
      rate[d] = byMotion ? nodes.motion(primary, d) - nodes.motion(enriched, d)
                         : nodes.projection(primary, d) - nodes.projection(enriched, d);
      more[d] = both ? sign * dt * rate[d] : -node.jump(d);
      node.jump(d) += more[d];
    }
    energy(primary) = 0.0;
    if (!node.isReleased())
    {
      const Vector<D> stretch = node.opening();
      energy(primary) = 0.5 * spring(primary, D) * dot(stretch, stretch);
      setForce(spring, primary,
               pullOf(spring(primary, D), stretch, sign) - (both ? damping(primary) : 0.0) * rate);
      if (counts)
        elastic += energy(primary);
      return;
    }
    const double pending = node.pendingEnergy(from);
    open(primary, node);
    const Vector<D> after = pullOf(spring(primary, D), node.opening(), sign);
    setForce(spring, primary, after);
    double dissipated = 0.0;
    for (int d = 0; d < D; ++d)
      dissipated -= 0.5 * sign * (before[d] + after[d]) * more[d];
    if (!both || !counts)
      return;
    work += dissipated;
    if (pending > 0.0 && node.state() == SpringState::Open &&
        dissipated > pending + springs::toleratedExcess * node.law().energy())
    {
      beyond += excess(i) = dissipated - pending;
      springs.front(primary) =
          frontOf(positions(primary), (side(primary) > 0 ? side(primary) : -side(primary)) - 1);
    }
  }

private:
  /// Softens a traction by its law where its node has opened more than ever.
  KOKKOS_INLINE_FUNCTION void open(int primary, const NodalSpring<D>& node) const
  {
    const Vector<D> u = node.opening();
    const double square = dot(u, u);
    if (!(square > node.largest() * node.largest()))
      return;
    node.largest() = std::sqrt(square);
    const CohesiveLaw law = node.law();
    const double now = law.secant(node.largest());
    spring(primary, D) = now < spring(primary, D) ? now : spring(primary, D);
    if (law.isOpen(node.largest()))
      node.setState(SpringState::Open);
  }
};

} // namespace

template <int D>
void FrontSprings<D>::addForces(State<D>& state) const
{
  const Nodes<D> nodes = state.mesh.nodes;
  const View<int*> side = state.cracks.nodeSide;
  const NodalSprings<D> all = springs(state);
  const View<double * [D + 1]> spring = state.cracks.spring;
  const View<double*> damping = damping_, damped = dampedInSubsteps_;
  const View<double* [D]> dampingForce = dampingForce_;
  parallelForSmall(
      "rhegma::cracks::addSprings", nodes.numOfCracks, KOKKOS_LAMBDA(const int i) {
        const int primary = nodes.parent(i), enriched = nodes.numLattice + i;
        Vector<D> rate{};
        for (int d = 0; d < D && damping(primary) > 0.0; ++d)
          rate[d] = nodes.sums(primary, Nodes<D>::momentumAt + d) / nodes.sums(primary, Nodes<D>::massAt) -
                    nodes.sums(enriched, Nodes<D>::momentumAt + d) / nodes.sums(enriched, Nodes<D>::massAt);
        const Vector<D> ofDamping = -damping(primary) * rate;
        setForce(dampingForce, primary, ofDamping);
        damped(primary) = 0.0;
        setForce(spring, primary,
                 pullOf(spring(primary, D), all(primary).opening(), signOf(side(primary))) + ofDamping);
        for (int d = 0; d < D && isOwnedByThisRank(nodes, primary); ++d)
        {
          nodes.sums(primary, Nodes<D>::forceAt + d) += spring(primary, d);
          nodes.sums(enriched, Nodes<D>::forceAt + d) -= spring(primary, d);
        }
      });
}

template <int D>
void FrontSprings<D>::release(State<D>& state, const Surroundings& surroundings,
                              const ToughnessAlong<D>& toughness)
{
  double passed = passed_;
  maxParts(state, &passed, 1);
  if (passed > 0.0)
    releasePassedNodes(state, surroundings, springs(state), toughness);
  passed_ = 0;
}

template <int D>
DisplacementDependentForce<D> FrontSprings<D>::displacementDependentForce() const
{
  using Values = View<double* [D]>;
  const auto frozen = [](const State<D>& state, const NodeSlots& slots, const Values& force)
  {
    const Nodes<D> nodes = state.mesh.nodes;
    const View<double * [D + 1]> spring = state.cracks.spring;
    Kokkos::parallel_for(
        "rhegma::cracks::frozenSprings", Kokkos::RangePolicy<ExecSpace>(0, nodes.numOfCracks),
        KOKKOS_LAMBDA(const int i) {
          const int primary = nodes.parent(i), enriched = nodes.numLattice + i;
          if (slots.moves(primary) == slots.moves(enriched) || !isOwnedByThisRank(nodes, primary))
            return;
          const int at = slots.of(slots.moves(primary) ? primary : enriched);
          for (int d = 0; d < D; ++d)
            force(at, d) += slots.moves(primary) ? spring(primary, d) : -spring(primary, d);
        });
  };
  const auto change = [this](const State<D>& state, const NodeSlots& slots, const Values& displacement,
                             const Values& velocity, const Values& force)
  {
    const Nodes<D> nodes = state.mesh.nodes;
    const View<double * [D + 1]> spring = state.cracks.spring;
    const View<int*> side = state.cracks.nodeSide;
    const View<double*> damping = damping_;
    const View<double* [D]> dampingForce = dampingForce_;
    const NodalSprings<D> all = springs(state);
    Kokkos::parallel_for(
        "rhegma::cracks::changeOfSprings", Kokkos::RangePolicy<ExecSpace>(0, nodes.numOfCracks),
        KOKKOS_LAMBDA(const int i) {
          const int primary = nodes.parent(i), enriched = nodes.numLattice + i;
          if (spring(primary, D) == 0.0 || !slots.moves(primary) || !slots.moves(enriched) ||
              !isOwnedByThisRank(nodes, primary))
            return;
          const int a = slots.of(primary), b = slots.of(enriched);
          const double sign = signOf(side(primary));
          const NodalSpring<D> node = all(primary);
          Vector<D> u, rate;
          for (int d = 0; d < D; ++d)
          {
            u[d] = node.jump(d) + sign * (displacement(a, d) - displacement(b, d)) + node.offset(d);
            rate[d] = velocity(a, d) - velocity(b, d);
          }
          double stiffness = spring(primary, D);
          if (node.isReleased() && dot(u, u) > node.largest() * node.largest())
            stiffness = std::fmin(stiffness, node.law().secant(norm(u)));
          const Vector<D> ofDamping = -damping(primary) * rate;
          setForce(dampingForce, primary, ofDamping);
          const Vector<D> more = pullOf(stiffness, u, sign) + ofDamping - forceOf<D>(spring, primary);
          for (int d = 0; d < D; ++d)
          {
            force(a, d) += more[d];
            force(b, d) -= more[d];
          }
        });
  };
  return {frozen, change, dampingInSubsteps()};
}

template <int D>
void FrontSprings<D>::advance(State<D>& state)
{
  const View<double*> excess("rhegma::cracks::excess", grows_ ? state.mesh.nodes.numOfCracks : 0);
  const StretchSpring<D> stretch{state.mesh.nodes,
                                 nodePositions(state),
                                 state.cracks.nodeSide,
                                 springs(state),
                                 state.cracks.spring,
                                 damping_,
                                 frontOf_,
                                 excess,
                                 state.cracks.springEnergy,
                                 state.clock.strainPass.fraction * state.clock.dt,
                                 state.method.scheme == UpdateScheme::Usl,
                                 state.clock.strainPass.before};
  double elastic = 0.0, dissipated = 0.0, beyond = 0.0;
  parallelSumSmall("rhegma::cracks::stretchSprings", 0, state.mesh.nodes.numOfCracks, stretch, elastic,
                   dissipated, beyond);
  state.energy.springs = elastic;
  state.energy.fracture += dissipated;
  std::vector<CrackFront<D>>& fronts = state.cracks.fronts;
  const bool any = std::any_of(fronts.begin(), fronts.end(), [](const CrackFront<D>& f) { return f.grown; });
  if (!grows_ || !any)
    return;
  sumParts(state, &beyond, 1);
  if (!(beyond > 0.0))
    return;
  const std::vector<double> energy = sumByFront(state, springs(state), excess);
  for (std::size_t f = 0; f < fronts.size(); ++f)
    fronts[f].budget.overDissipate(energy[f]);
}

// The velocities are those with which the kinetic energy of the particles changes by the work of all forces.
// c |v|^2 dt with one velocity differs from that work by up to 40 % where c dt is large next to the mass.
template <int D>
void FrontSprings<D>::recordDamping(State<D>& state) const
{
  const Nodes<D> nodes = state.mesh.nodes;
  const LoadVelocity<D> velocity(state);
  const NodeSlots subcycled = state.motion.substeps.nodes;
  const View<double* [D]> force = dampingForce_;
  const View<double*> inSubsteps = dampedInSubsteps_;
  const double dt = state.clock.dt;
  double damped = 0.0;
  parallelSumSmall(
      "rhegma::cracks::recordDamping", 0, nodes.numOfCracks,
      KOKKOS_LAMBDA(const int i, double& sum) {
        const int primary = nodes.parent(i), enriched = nodes.numLattice + i;
        if (!isOwnedByThisRank(nodes, primary))
          return;
        if (subcycled.moves(primary) && subcycled.moves(enriched))
        {
          sum += inSubsteps(primary);
          return;
        }
        for (int d = 0; d < D; ++d)
          sum -= dt * force(primary, d) * (velocity(primary, d) - velocity(enriched, d));
      },
      damped);
  state.energy.stabilised += damped;
}

template <int D>
typename DisplacementDependentForce<D>::Work FrontSprings<D>::dampingInSubsteps() const
{
  return [this](const State<D>& state, const NodeSlots& slots, const View<double* [D]>& velocity,
                double duration)
  {
    const Nodes<D> nodes = state.mesh.nodes;
    const View<double* [D]> force = dampingForce_;
    const View<double*> damped = dampedInSubsteps_;
    parallelForSmall(
        "rhegma::cracks::dampingInSubsteps", nodes.numOfCracks, KOKKOS_LAMBDA(const int i) {
          const int primary = nodes.parent(i), enriched = nodes.numLattice + i;
          if (!slots.moves(primary) || !slots.moves(enriched))
            return;
          const int a = slots.of(primary), b = slots.of(enriched);
          for (int d = 0; d < D; ++d)
            damped(primary) -= duration * force(primary, d) * (velocity(a, d) - velocity(b, d));
        });
  };
}

template <int D>
double FrontSprings<D>::pendingEnergy(const State<D>& state, int step) const
{
  const Nodes<D> nodes = state.mesh.nodes;
  const NodalSprings<D> all = springs(state);
  // A run that fails between steps may have other nodes already than the field.
  const int count = std::min(nodes.numLattice, static_cast<int>(all.rows.extent(0)));
  double sum = parallelSumSmall<double>(
      "rhegma::cracks::pendingEnergy", count, KOKKOS_LAMBDA(const int n, double& sumHere) {
        const NodalSpring<D> node = all(n);
        if (step > 0 && static_cast<int>(node.step()) == step && isOwnedByThisRank(nodes, n))
          sumHere += node.pendingEnergy(node.opening());
      });
  sumParts(state, &sum, 1);
  for (const CrackFront<D>& front : state.cracks.fronts)
    sum += front.budget.pending;
  return sum;
}

template void FrontSprings<2>::addForces(State<2>&) const;
template void FrontSprings<3>::addForces(State<3>&) const;
template void FrontSprings<2>::release(State<2>&, const Surroundings&, const ToughnessAlong<2>&);
template void FrontSprings<3>::release(State<3>&, const Surroundings&, const ToughnessAlong<3>&);
template DisplacementDependentForce<2> FrontSprings<2>::displacementDependentForce() const;
template DisplacementDependentForce<3> FrontSprings<3>::displacementDependentForce() const;
template void FrontSprings<2>::advance(State<2>&);
template void FrontSprings<3>::advance(State<3>&);
template void FrontSprings<2>::recordDamping(State<2>&) const;
template void FrontSprings<3>::recordDamping(State<3>&) const;
template DisplacementDependentForce<2>::Work FrontSprings<2>::dampingInSubsteps() const;
template DisplacementDependentForce<3>::Work FrontSprings<3>::dampingInSubsteps() const;
template double FrontSprings<2>::pendingEnergy(const State<2>&, int) const;
template double FrontSprings<3>::pendingEnergy(const State<3>&, int) const;

} // namespace Rhegma::cracks
