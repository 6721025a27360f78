#include "boundary/BodyForce.hpp"

#include "boundary/LoadVelocity.hpp"

namespace Rhegma
{

template <int D>
void addBodyForce(const Nodes<D>& nodes, const Vector<D>& acceleration)
{
  Kokkos::parallel_for(
      "rhegma::addBodyForce", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i) {
        const int n = activeNode(nodes, i);
        for (int d = 0; d < D && countsHere(nodes, n); ++d)
          nodes.sums(n, Nodes<D>::forceAt + d) += nodes.sums(n, Nodes<D>::massAt) * acceleration[d];
      });
}

template <int D>
double bodyForceWork(const State<D>& state, const Vector<D>& acceleration)
{
  const Nodes<D> nodes = state.mesh.nodes;
  const LoadVelocity<D> velocity(state);
  const double dt = state.clock.dt;
  double work = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::bodyForceWork", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i, double& sum) {
        const int n = activeNode(nodes, i);
        for (int d = 0; d < D && countsHere(nodes, n); ++d)
          sum += dt * acceleration[d] * nodes.sums(n, Nodes<D>::massAt) * velocity(n, d);
      },
      work);
  return work;
}

template void addBodyForce(const Nodes<2>&, const Vector<2>&);
template void addBodyForce(const Nodes<3>&, const Vector<3>&);
template double bodyForceWork(const State<2>&, const Vector<2>&);
template double bodyForceWork(const State<3>&, const Vector<3>&);

} // namespace Rhegma
