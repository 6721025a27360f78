#include "boundary/Boundaries.hpp"

namespace Rhegma
{

namespace
{

/// Mean velocity of a held node over a step [m/s], as seen by the stresses: the forces at the start and at
/// the end of a step count half, each with the velocity of the step before or after it. In substeps the node
/// has its new velocity from the start, so that the mean differs by half a substep only.
template <int D>
struct MeanOfHeld
{
  NodeConstraint<D> now, before;
  NodeSlots substeps;
  double fraction = 1.0; ///< of a substep in a step

  MeanOfHeld() = default;
  MeanOfHeld(const State<D>& state, const NodeConstraint<D>& constraint, const NodeConstraint<D>& earlier)
      : now(constraint),
        before(earlier),
        substeps(state.motion.substeps.nodes),
        fraction(state.motion.substeps.length / state.clock.dt)
  {
  }

  KOKKOS_INLINE_FUNCTION double operator()(int node, int lattice, int axis) const
  {
    const double value = now.at(lattice, axis), half = substeps.moves(node) ? 0.5 * fraction : 0.5;
    return value - half * (value - before.at(lattice, axis));
  }
};

/// Holds the nodes and sums the work and the impulse. An array reduction in a single pass.
template <int D>
struct HoldNodes
{
  using value_type = double[];
  using size_type = int;
  using execution_space = ExecSpace;

  int value_count = 1 + D;
  Nodes<D> nodes;
  NodePositions<D> positions;
  NodeConstraint<D> constraint;
  MeanOfHeld<D> mean;
  View<int*> coupledRow;         ///< empty where all masses are lumped
  View<double*> coupledReaction; ///< impulse on each unknown of coupled nodes
  double dt;
  bool bySmoothing; ///< constrainProjection adds the rest of the work

  KOKKOS_INLINE_FUNCTION void operator()(const int i, double* sum) const
  {
    const int n = activeNode(nodes, i);
    const double mass = nodes.sums(n, Nodes<D>::massAt);
    const int lattice = latticeNode(nodes, n);
    if (!(mass > 0.0) || !constraint.appliesAt(positions(lattice)))
      return;
    const int row = coupledRow.extent(0) > 0 ? coupledRow(n) : -1;
    for (int d = 0; d < D; ++d)
      if (constraint.holds[d] && row >= 0)
      {
        // Held during the solve; where two supports hold a node the first gets the force.
        const double between = nodes.motion(n, d) - 0.5 * dt * nodes.motion(n, Nodes<D>::accelerationAt + d);
        const double impulse = coupledReaction(row * D + d);
        coupledReaction(row * D + d) = 0.0;
        if (isOwnedByThisRank(nodes, n))
        {
          sum[0] += impulse * between;
          sum[1 + d] += impulse;
        }
      }
      else if (constraint.holds[d])
      {
        const double before = nodes.sums(n, Nodes<D>::momentumAt + d) / mass;
        const double value = constraint.at(lattice, d);
        const double impulse = mass * (value - nodes.motion(n, d));
        if (isOwnedByThisRank(nodes, n))
        {
          sum[0] += impulse * (bySmoothing ? mean(n, lattice, d) : 0.5 * (value + before));
          sum[1 + d] += impulse;
        }
        nodes.motion(n, d) = value;
        nodes.motion(n, Nodes<D>::accelerationAt + d) = (value - before) / dt;
      }
  }
};

} // namespace

template <int D>
Reaction<D> constrainMotion(State<D>& state, const NodeConstraint<D>& constraint,
                            const NodeConstraint<D>& earlier)
{
  HoldNodes<D> hold;
  hold.nodes = state.mesh.nodes;
  hold.positions = nodePositions(state);
  hold.constraint = constraint;
  hold.mean = MeanOfHeld<D>(state, constraint, earlier);
  hold.coupledRow = state.motion.coupledRow;
  hold.coupledReaction = state.motion.coupledReaction;
  hold.dt = state.clock.dt;
  hold.bySmoothing = projectsLast(state.method.scheme);
  double sum[1 + D] = {};
  Kokkos::parallel_reduce("rhegma::constrainMotion",
                          Kokkos::RangePolicy<ExecSpace>(0, state.mesh.nodes.numActive()), hold, sum);
  Reaction<D> reaction{sum[0], {}};
  for (int d = 0; d < D; ++d)
    reaction.impulse[d] = sum[1 + d];
  return reaction;
}

template <int D>
double constrainProjection(State<D>& state, const NodeConstraint<D>& constraint,
                           const NodeConstraint<D>& earlier, const View<char**>& held)
{
  const Nodes<D> nodes = state.mesh.nodes;
  const NodePositions<D> positions = nodePositions(state);
  const View<int*> coupledRow = state.motion.coupledRow;
  const bool afterMotion = projectsLast(state.method.scheme) && !state.clock.strainPass.before;
  const MeanOfHeld<D> mean(state, constraint, earlier);
  double work = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::constrainProjection", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i, double& sum) {
        const int n = activeNode(nodes, i);
        const int lattice = latticeNode(nodes, n);
        if (!constraint.appliesAt(positions(lattice)))
          return;
        const double mass = nodes.sums(n, Nodes<D>::massAt);
        const bool recorded = !afterMotion || !(mass > 0.0) || !isOwnedByThisRank(nodes, n) ||
                              (coupledRow.extent(0) > 0 && coupledRow(n) >= 0);
        for (int d = 0; d < D; ++d)
          if (constraint.holds[d])
          {
            const double value = constraint.at(lattice, d), after = nodes.projection(n, d);
            const bool first = held.extent(0) == 0 || held(n, d) == 0;
            if (held.extent(0) > 0)
              held(n, d) = 1;
            if (!recorded && first)
            {
              const double before = nodes.sums(n, Nodes<D>::momentumAt + d) / mass;
              sum += mass * (value - before) * (0.5 * (before + after) - mean(n, lattice, d));
            }
            nodes.projection(n, d) = value;
          }
      },
      work);
  return work;
}

template Reaction<2> constrainMotion(State<2>&, const NodeConstraint<2>&, const NodeConstraint<2>&);
template Reaction<3> constrainMotion(State<3>&, const NodeConstraint<3>&, const NodeConstraint<3>&);
template double constrainProjection(State<2>&, const NodeConstraint<2>&, const NodeConstraint<2>&,
                                    const View<char**>&);
template double constrainProjection(State<3>&, const NodeConstraint<3>&, const NodeConstraint<3>&,
                                    const View<char**>&);

} // namespace Rhegma
