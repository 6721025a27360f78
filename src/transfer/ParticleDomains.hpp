#pragma once
/// The domains of particles.

#include "state/State.hpp"

namespace Rhegma
{

/// The domain of each particle: the parallelogram (2D) or parallelepiped (3D) into which its undeformed box
/// is deformed, about its position.
template <int D>
struct ParticleDomains
{
  View<double* [D][D]> axes; ///< of bodies
  BorrowedView<int*> body;
  BorrowedView<double* [D]> edge;
  BorrowedView<double * [gradientSize<D>]> deformation;

  /// Its edge vectors [m].
  KOKKOS_INLINE_FUNCTION void edgesOf(int p, Vector<D> (&edges)[D]) const
  {
    for (int e = 0; e < D; ++e)
      for (int i = 0; i < D; ++i)
      {
        edges[e][i] = 0.0;
        for (int j = 0; j < D; ++j)
          edges[e][i] += edge(p, e) * deformation(p, i * D + j) * axes(body(p), e, j);
      }
  }
};

/// The domains of the current particles.
template <int D>
ParticleDomains<D> particleDomains(const State<D>& state)
{
  return {state.bodies.axes, state.particles.integer(fields::body),
          state.particles.template real<D>(fields::edge),
          state.particles.template real<gradientSize<D>>(fields::deformation)};
}

} // namespace Rhegma
