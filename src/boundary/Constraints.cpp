#include "boundary/Boundaries.hpp"

namespace Rhegma
{

namespace
{

/// Holds the nodes and sums the work and the impulse. An array reduction, so that one pass gives all.
template <int D>
struct HoldNodes
{
  using value_type = double[];
  using size_type = int;
  using execution_space = ExecSpace;

  int value_count = 1 + D;
  Nodes<D> nodes;
  NodePlaces<D> places;
  NodeConstraint<D> constraint;
  View<int*> coupledRow;         ///< empty where all masses are lumped
  View<double*> coupledReaction; ///< impulse on each unknown of coupled nodes
  double dt;

  KOKKOS_INLINE_FUNCTION void operator()(const int i, double* sum) const
  {
    const int n = activeNode(nodes, i);
    const double mass = nodes.sums(n, Nodes<D>::massAt);
    const int lattice = latticeNode(nodes, n);
    if (!(mass > 0.0) || !constraint.appliesAt(places(lattice)))
      return;
    const int row = coupledRow.extent(0) > 0 ? coupledRow(n) : -1;
    for (int d = 0; d < D; ++d)
      if (constraint.holds[d] && row >= 0)
      {
        // Held while it was solved; where two supports hold a node the first takes the force.
        const double mean = nodes.motion(n, d) - 0.5 * dt * nodes.motion(n, Nodes<D>::accelerationAt + d);
        const double impulse = coupledReaction(row * D + d);
        coupledReaction(row * D + d) = 0.0;
        if (countsHere(nodes, n))
        {
          sum[0] += impulse * mean;
          sum[1 + d] += impulse;
        }
      }
      else if (constraint.holds[d])
      {
        const double before = nodes.sums(n, Nodes<D>::momentumAt + d) / mass;
        const double value = constraint.at(lattice, d);
        const double impulse = mass * (value - nodes.motion(n, d));
        if (countsHere(nodes, n))
        {
          sum[0] += impulse * 0.5 * (value + before);
          sum[1 + d] += impulse;
        }
        nodes.motion(n, d) = value;
        nodes.motion(n, Nodes<D>::accelerationAt + d) = (value - before) / dt;
      }
  }
};

} // namespace

template <int D>
Reaction<D> constrainMotion(State<D>& state, const NodeConstraint<D>& constraint)
{
  HoldNodes<D> hold;
  hold.nodes = state.nodes;
  hold.places = nodePlaces(state);
  hold.constraint = constraint;
  hold.coupledRow = state.coupledRow;
  hold.coupledReaction = state.coupledReaction;
  hold.dt = state.dt;
  double sum[1 + D] = {};
  Kokkos::parallel_reduce("rhegma::constrainMotion",
                          Kokkos::RangePolicy<ExecSpace>(0, state.nodes.numActive()), hold, sum);
  Reaction<D> reaction{sum[0], {}};
  for (int d = 0; d < D; ++d)
    reaction.impulse[d] = sum[1 + d];
  return reaction;
}

template <int D>
void constrainProjection(State<D>& state, const NodeConstraint<D>& constraint)
{
  const Nodes<D> nodes = state.nodes;
  const NodePlaces<D> places = nodePlaces(state);
  Kokkos::parallel_for(
      "rhegma::constrainProjection", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i) {
        const int n = activeNode(nodes, i);
        const int lattice = latticeNode(nodes, n);
        if (!constraint.appliesAt(places(lattice)))
          return;
        for (int d = 0; d < D; ++d)
          if (constraint.holds[d])
            nodes.projection(n, d) = constraint.at(lattice, d);
      });
}

template Reaction<2> constrainMotion(State<2>&, const NodeConstraint<2>&);
template Reaction<3> constrainMotion(State<3>&, const NodeConstraint<3>&);
template void constrainProjection(State<2>&, const NodeConstraint<2>&);
template void constrainProjection(State<3>&, const NodeConstraint<3>&);

} // namespace Rhegma
