#include "transfer/Motion.hpp"

namespace Rhegma
{

namespace
{

template <int D>
void divideByMass(const Nodes<D>& nodes, double dt, const char* label)
{
  Kokkos::parallel_for(
      label, Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()), KOKKOS_LAMBDA(const int i) {
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

} // namespace

template <int D>
void solveLumped(State<D>& state)
{
  divideByMass(state.mesh.nodes, state.clock.dt, "rhegma::solveLumped");
}

template <int D>
void nodalVelocity(State<D>& state)
{
  divideByMass(state.mesh.nodes, 0.0, "rhegma::nodalVelocity");
}

template void solveLumped(State<2>&);
template void solveLumped(State<3>&);
template void nodalVelocity(State<2>&);
template void nodalVelocity(State<3>&);

} // namespace Rhegma
