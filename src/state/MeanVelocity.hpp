#pragma once
/// The velocity for the work of forces.

#include "state/State.hpp"

namespace Rhegma
{

/// After the solve, the velocity [m/s] for the work of a force that acts on a node throughout the step: the
/// mean of the velocities before and after the step; for a node that moves in substeps, the mean over the
/// substeps.
template <int D>
struct MeanVelocity
{
  Nodes<D> nodes;           ///< of the state
  NodeSlots subcycled;      ///< nodes that move in substeps
  double half, substepHalf; ///< half of the step and of the shortest substep [s]

  explicit MeanVelocity(const State<D>& state)
      : nodes(state.mesh.nodes),
        subcycled(state.motion.substeps.nodes),
        half(0.5 * state.clock.dt),
        substepHalf(0.5 * state.motion.substeps.length)
  {
  }

  /// Along an axis [m/s]. The stored velocity of nodes that move in substeps is already their mean.
  KOKKOS_INLINE_FUNCTION double operator()(int node, int axis) const
  {
    const double time = subcycled.moves(node) ? substepHalf : half;
    return nodes.motion(node, axis) - time * nodes.motion(node, Nodes<D>::accelerationAt + axis);
  }
};

} // namespace Rhegma
