#pragma once
/// The velocity with which faces move.

#include "state/MeanVelocity.hpp"

namespace Rhegma
{

/// The velocity [m/s] at which the room between faces changes over a step: with MUSL and USAVG that which
/// strains the particles and moves the faces, so that what solid gives up is what room gains; it is known
/// after the projection. With other schemes the mean of those before and after the step.
///
/// A force that some node bears on which no particle's stress bears as much accelerates the node in every
/// step anew and no particle. At the velocity of the solve it would sweep room that is none, and work that no
/// body gets: of faces two cells apart four times the room that there is.
template <int D>
struct FaceVelocity
{
  MeanVelocity<D> mean; ///< of before and after the step
  bool projected;       ///< whether a step ends with a projection (MUSL, USAVG)

  /// Of a state after its solve; with MUSL and USAVG after its projection.
  explicit FaceVelocity(const State<D>& state) : mean(state), projected(projectsLast(state.method.scheme)) {}

  /// Of a node along an axis [m/s].
  KOKKOS_INLINE_FUNCTION double operator()(int node, int axis) const
  {
    return projected ? mean.nodes.projection(node, axis) : mean(node, axis);
  }
};

/// The velocity [m/s] at which a force on faces works over a step, so that the particles' kinetic energy
/// changes by the work of all forces: with MUSL and USAVG the mean v of what their momentum has nodes move
/// with before and after, for sum_p m_p (v_p'^2 - v_p^2) / 2 = sum_i m_i a_i dt . v_i, as a particle's
/// velocity changes by sum_i N_i a_i dt and a node's projection is sum_p N_p m_p v_p' / m_i. Of nodes that
/// move in substeps the velocity of their way.
template <int D>
struct WorkVelocity
{
  FaceVelocity<D> way; ///< at which room changes

  /// Of a state after its solve; with MUSL and USAVG after its projection.
  explicit WorkVelocity(const State<D>& state) : way(state) {}

  /// Of a node along an axis [m/s].
  KOKKOS_INLINE_FUNCTION double operator()(int node, int axis) const
  {
    const MeanVelocity<D>& mean = way.mean;
    if (!way.projected || mean.subcycled.moves(node))
      return way(node, axis);
    const double before = mean.nodes.motion(node, axis) -
                          2.0 * mean.half * mean.nodes.motion(node, Nodes<D>::accelerationAt + axis);
    return 0.5 * (before + mean.nodes.projection(node, axis));
  }
};

} // namespace Rhegma
