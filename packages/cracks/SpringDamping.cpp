/// The energy that the damping of front springs takes.

#include "base/SmallLoops.hpp"
#include "boundary/LoadVelocity.hpp"
#include "cracks/FrontSprings.hpp"
#include "state/Subdomain.hpp"

namespace Rhegma::cracks
{

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
      "rhegma::cracks::recordDamping", 0, nodes.numEnriched,
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
        "rhegma::cracks::dampingInSubsteps", nodes.numEnriched, KOKKOS_LAMBDA(const int i) {
          const int primary = nodes.parent(i), enriched = nodes.numLattice + i;
          if (!slots.moves(primary) || !slots.moves(enriched))
            return;
          const int a = slots.of(primary), b = slots.of(enriched);
          for (int d = 0; d < D; ++d)
            damped(primary) -= duration * force(primary, d) * (velocity(a, d) - velocity(b, d));
        });
  };
}

template void FrontSprings<2>::recordDamping(State<2>&) const;
template void FrontSprings<3>::recordDamping(State<3>&) const;
template DisplacementDependentForce<2>::Work FrontSprings<2>::dampingInSubsteps() const;
template DisplacementDependentForce<3>::Work FrontSprings<3>::dampingInSubsteps() const;

} // namespace Rhegma::cracks
