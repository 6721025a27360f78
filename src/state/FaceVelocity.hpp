#pragma once
/// The velocity of crack faces.

#include "state/MeanVelocity.hpp"

namespace Rhegma
{

/// The velocity [m/s] that changes the volume between faces over a step. With MUSL and USAVG it is the
/// projected velocity, which strains the particles and moves the faces, so that the gap gains the volume that
/// the solid loses; it is known after the projection. With other schemes it is the mean of the velocities
/// before and after the step.
///
/// The velocity of the solve is not used: a force on a node that no stress balances accelerates the node in
/// every step anew, but no particle. At that velocity it would sweep a volume that does not exist and do work
/// that no body receives; for faces two cells apart, four times the true volume.
template <int D>
struct FaceVelocity
{
  MeanVelocity<D> mean; ///< mean of before and after the step
  bool projected;       ///< whether a step ends with a projection (MUSL, USAVG)

  /// \param state after its solve; with MUSL and USAVG after its projection
  explicit FaceVelocity(const State<D>& state) : mean(state), projected(projectsLast(state.method.scheme)) {}

  /// Velocity of a node along an axis [m/s].
  KOKKOS_INLINE_FUNCTION double operator()(int node, int axis) const
  {
    return projected ? mean.nodes.projection(node, axis) : mean(node, axis);
  }
};

/// The velocity [m/s] for the work of a force on faces over a step, such that the kinetic energy of the
/// particles changes by the work of all forces. With MUSL and USAVG it is the mean v of the nodal velocities
/// projected before and after the step, because sum_p m_p (v_p'^2 - v_p^2) / 2 = sum_i m_i a_i dt . v_i, as a
/// particle's velocity changes by sum_i N_i a_i dt and a node's projection is sum_p N_p m_p v_p' / m_i. For
/// nodes that move in substeps it is their displacement over the step, divided by its length.
template <int D>
struct WorkVelocity
{
  FaceVelocity<D> face; ///< velocity of the faces

  /// \param state after its solve; with MUSL and USAVG after its projection
  explicit WorkVelocity(const State<D>& state) : face(state) {}

  /// Velocity of a node along an axis [m/s].
  KOKKOS_INLINE_FUNCTION double operator()(int node, int axis) const
  {
    const MeanVelocity<D>& mean = face.mean;
    if (!face.projected || mean.subcycled.moves(node))
      return face(node, axis);
    const double before = mean.nodes.motion(node, axis) -
                          2.0 * mean.half * mean.nodes.motion(node, Nodes<D>::accelerationAt + axis);
    return 0.5 * (before + mean.nodes.projection(node, axis));
  }
};

} // namespace Rhegma
