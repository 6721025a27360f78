#pragma once
/// The velocity at which loads work.

#include "state/FaceVelocity.hpp"

namespace Rhegma
{

/// WorkVelocity, but of nodes that move in substeps, in each of which a load pushes alike, the mean over
/// these [m/s].
template <int D>
struct LoadVelocity
{
  WorkVelocity<D> work; ///< of nodes that take the whole step

  /// Of a state after its solve; with MUSL and USAVG after its projection.
  explicit LoadVelocity(const State<D>& state) : work(state) {}

  /// Of a node along an axis [m/s].
  KOKKOS_INLINE_FUNCTION double operator()(int node, int axis) const
  {
    const MeanVelocity<D>& mean = work.way.mean;
    return mean.subcycled.moves(node) ? mean(node, axis) : work(node, axis);
  }
};

} // namespace Rhegma
