#include "transfer/Motion.hpp"

namespace Rhegma
{

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

template void solveLumped(State<2>&);
template void solveLumped(State<3>&);

} // namespace Rhegma
