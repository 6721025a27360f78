#pragma once
/// The velocity with which faces move.

#include "state/MeanVelocity.hpp"

namespace Rhegma
{

/// The velocity [m/s] at which the room between faces changes over a step: with MUSL that which strains the
/// particles and moves the faces, so that what solid gives up is what room gains; it is known after the
/// projection. With other schemes the mean of those before and after the step.
///
/// A force that some node bears on which no particle's stress bears as much accelerates the node in every
/// step anew and no particle. At the velocity of the solve it would sweep room that is none, and work that no
/// body gets: of faces two cells apart four times the room that there is.
template <int D>
struct WayVelocity
{
  MeanVelocity<D> mean;
  bool projected;

  explicit WayVelocity(const State<D>& state) : mean(state), projected(state.scheme == UpdateScheme::Musl) {}

  KOKKOS_INLINE_FUNCTION double operator()(int node, int axis) const
  {
    return projected ? mean.nodes.projection(node, axis) : mean(node, axis);
  }
};

} // namespace Rhegma
