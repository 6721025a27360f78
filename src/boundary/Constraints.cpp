#include "boundary/Boundaries.hpp"

namespace Rhegma
{

template <int D>
double constrainMotion(State<D>& state, const NodeConstraint<D>& constraint)
{
  const Nodes<D> nodes = state.nodes;
  const Grid<D> grid = state.grid;
  const double dt = state.dt;
  double work = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::constrainMotion", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i, double& sum) {
        const int n = activeNode(nodes, i);
        const double mass = nodes.sums(n, Nodes<D>::massAt);
        const int lattice = latticeNode(nodes, n);
        if (!(mass > 0.0) || !constraint.appliesAt(grid.nodePosition(lattice)))
          return;
        for (int d = 0; d < D; ++d)
          if (constraint.holds[d])
          {
            const double before = nodes.sums(n, Nodes<D>::momentumAt + d) / mass;
            const double free = nodes.motion(n, d), value = constraint.at(lattice, d);
            sum += mass * (value - free) * 0.5 * (value + before);
            nodes.motion(n, d) = value;
            nodes.motion(n, Nodes<D>::accelerationAt + d) = (value - before) / dt;
          }
      },
      work);
  return work;
}

template <int D>
void constrainProjection(State<D>& state, const NodeConstraint<D>& constraint)
{
  const Nodes<D> nodes = state.nodes;
  const Grid<D> grid = state.grid;
  Kokkos::parallel_for(
      "rhegma::constrainProjection", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i) {
        const int n = activeNode(nodes, i);
        const int lattice = latticeNode(nodes, n);
        if (!constraint.appliesAt(grid.nodePosition(lattice)))
          return;
        for (int d = 0; d < D; ++d)
          if (constraint.holds[d])
            nodes.projection(n, d) = constraint.at(lattice, d);
      });
}

template double constrainMotion(State<2>&, const NodeConstraint<2>&);
template double constrainMotion(State<3>&, const NodeConstraint<3>&);
template void constrainProjection(State<2>&, const NodeConstraint<2>&);
template void constrainProjection(State<3>&, const NodeConstraint<3>&);

} // namespace Rhegma
