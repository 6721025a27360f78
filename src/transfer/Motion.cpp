#include "transfer/Motion.hpp"

#include "base/SmallLoops.hpp"

namespace Rhegma
{

template <int D>
void resistRelativeMotion(State<D>& state)
{
  const View<double*> added = state.motion.relativeInertia.mass;
  if (added.extent(0) == 0)
    return;
  const Nodes<D> nodes = state.mesh.nodes;
  const NodeSlots subcycled = state.motion.substeps.nodes;
  const View<double* [D]> inertia = state.motion.relativeInertia.force;
  parallelForSmall(
      "rhegma::resistRelativeMotion", nodes.numEnriched, KOKKOS_LAMBDA(const int i) {
        const int primary = nodes.parent(i), enriched = nodes.numLattice + i;
        const double a = nodes.sums(primary, Nodes<D>::massAt), b = nodes.sums(enriched, Nodes<D>::massAt);
        const bool acts = added(primary) > 0.0 && !(subcycled.moves(primary) && subcycled.moves(enriched));
        for (int d = 0; d < D; ++d)
        {
          double& force = nodes.sums(primary, Nodes<D>::forceAt + d);
          double& other = nodes.sums(enriched, Nodes<D>::forceAt + d);
          inertia(primary, d) = acts ? relativeInertiaForce(a, b, force, other, added(primary)) : 0.0;
          force += inertia(primary, d);
          other -= inertia(primary, d);
        }
      });
}

template <int D>
void solveLumped(State<D>& state)
{
  const Nodes<D> nodes = state.mesh.nodes;
  const double dt = state.clock.dt;
  Kokkos::parallel_for(
      "rhegma::solveLumped", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i) {
        const int n = activeNode(nodes, i);
        const double mass = nodes.sums(n, Nodes<D>::massAt);
        const double inverse = mass > 0.0 ? 1.0 / mass : 0.0;
        for (int d = 0; d < D; ++d)
        {
          const double acceleration = dt > 0.0 ? inverse * nodes.sums(n, Nodes<D>::forceAt + d) : 0.0;
          nodes.motion(n, d) = inverse * nodes.sums(n, Nodes<D>::momentumAt + d) + dt * acceleration;
          nodes.motion(n, Nodes<D>::accelerationAt + d) = acceleration;
        }
      });
}

template void resistRelativeMotion(State<2>&);
template void resistRelativeMotion(State<3>&);
template void solveLumped(State<2>&);
template void solveLumped(State<3>&);

} // namespace Rhegma
