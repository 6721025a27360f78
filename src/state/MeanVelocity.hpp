#pragma once
/// The velocity at which forces work.

#include "state/State.hpp"

namespace Rhegma
{

/// After the solve, the velocity [m/s] at which a force works that acts on a node all through the step: the
/// mean of those before and after it; of a node that moves in substeps the mean over all of them.
template <int D>
struct MeanVelocity
{
  Nodes<D> nodes;           ///< of the state
  NodeSlots subcycled;      ///< nodes that move in substeps
  double half, substepHalf; ///< of the step and of the shortest steps [s]

  explicit MeanVelocity(const State<D>& state)
      : nodes(state.mesh.nodes),
        subcycled(state.motion.substeps.nodes),
        half(0.5 * state.clock.dt),
        substepHalf(0.5 * state.motion.substeps.length)
  {
  }

  /// Along an axis. The velocity of nodes that move in substeps is already that of their way.
  KOKKOS_INLINE_FUNCTION double operator()(int node, int axis) const
  {
    const double time = subcycled.moves(node) ? substepHalf : half;
    return nodes.motion(node, axis) - time * nodes.motion(node, Nodes<D>::accelerationAt + axis);
  }
};

} // namespace Rhegma
