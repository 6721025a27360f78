#pragma once
/// The velocity for the work of loads.

#include "state/FaceVelocity.hpp"

namespace Rhegma
{

/// As WorkVelocity [m/s], but for nodes that move in substeps the mean over the substeps, in each of which
/// the load is the same.
template <int D>
struct LoadVelocity
{
  WorkVelocity<D> work; ///< of nodes that take the whole step

  /// \param state after its solve; with MUSL and USAVG after its projection
  explicit LoadVelocity(const State<D>& state) : work(state) {}

  /// Of a node along an axis [m/s].
  KOKKOS_INLINE_FUNCTION double operator()(int node, int axis) const
  {
    const MeanVelocity<D>& mean = work.face.mean;
    return mean.subcycled.moves(node) ? mean(node, axis) : work(node, axis);
  }
};

} // namespace Rhegma
