#include "boundary/Boundaries.hpp"

namespace Rhegma
{

namespace
{

template <int D>
KOKKOS_INLINE_FUNCTION bool applies(const NodeConstraint<D>& constraint, const Vector<D>& x)
{
  bool in = true;
  for (int d = 0; d < D; ++d)
    in = in && x[d] >= constraint.lower[d] && x[d] <= constraint.upper[d];
  return in;
}

} // namespace

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
        if (!(mass > 0.0) || !applies(constraint, grid.nodePosition(latticeNode(nodes, n))))
          return;
        for (int d = 0; d < D; ++d)
          if (constraint.holds[d])
          {
            const double before = nodes.sums(n, Nodes<D>::momentumAt + d) / mass;
            const double free = nodes.motion(n, d);
            sum += mass * (constraint.value[d] - free) * 0.5 * (constraint.value[d] + before);
            nodes.motion(n, d) = constraint.value[d];
            nodes.motion(n, Nodes<D>::accelerationAt + d) = (constraint.value[d] - before) / dt;
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
        if (!applies(constraint, grid.nodePosition(latticeNode(nodes, n))))
          return;
        for (int d = 0; d < D; ++d)
          if (constraint.holds[d])
            nodes.projection(n, d) = constraint.value[d];
      });
}

template double constrainMotion(State<2>&, const NodeConstraint<2>&);
template double constrainMotion(State<3>&, const NodeConstraint<3>&);
template void constrainProjection(State<2>&, const NodeConstraint<2>&);
template void constrainProjection(State<3>&, const NodeConstraint<3>&);

} // namespace Rhegma
