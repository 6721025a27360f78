#include "transfer/Motion.hpp"

#include "base/SmallLoops.hpp"

namespace Rhegma
{

template <int D>
void slowRelativeMotion(State<D>& state, RelativePart part)
{
  const View<double*> added = state.motion.relativeInertia;
  if (added.extent(0) == 0)
    return;
  const Nodes<D> nodes = state.mesh.nodes;
  const bool velocity = part == RelativePart::Projection;
  const int at = part == RelativePart::Force ? Nodes<D>::forceAt : Nodes<D>::momentumAt;
  parallelForSmall(
      "rhegma::slowRelativeMotion", nodes.numOfCracks, KOKKOS_LAMBDA(const int i) {
        const int primary = nodes.parent(i), enriched = nodes.numLattice + i;
        if (!(added(primary) > 0.0))
          return;
        const double a = nodes.sums(primary, Nodes<D>::massAt), b = nodes.sums(enriched, Nodes<D>::massAt);
        for (int d = 0; d < D; ++d)
        {
          double& value = velocity ? nodes.projection(primary, d) : nodes.sums(primary, at + d);
          double& other = velocity ? nodes.projection(enriched, d) : nodes.sums(enriched, at + d);
          const double unit = velocity ? a : 1.0, otherUnit = velocity ? b : 1.0;
          const double taken = takenByInertia(a, b, unit * value, otherUnit * other, added(primary));
          value -= taken / unit;
          other += taken / otherUnit;
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

template void slowRelativeMotion(State<2>&, RelativePart);
template void slowRelativeMotion(State<3>&, RelativePart);
template void solveLumped(State<2>&);
template void solveLumped(State<3>&);

} // namespace Rhegma
