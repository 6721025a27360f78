#pragma once
/// Heat flux in a particle.

#include "material/Tensors.hpp"
#include "transfer/ParticleViews.hpp"

namespace Rhegma::thermal
{

/// Conduction in the particles of a state, with the conductivity at their temperatures.
template <int D>
struct ParticleFlux
{
  ThermoTables tables;
  View<double* [D][D]> axes;
  BorrowedView<double*> volume, temperature;
  BorrowedView<double * [gradientSize<D>]> deformation;
  BorrowedView<int*> material, body;
  bool undeformed; ///< whether the cells are: heat flows as in the undeformed body

  /// [W/(m K)]
  KOKKOS_INLINE_FUNCTION double conductivity(int p) const
  {
    return ThermoPoint(tables, material(p), temperature(p)).conductivity();
  }

  /// Volume times -k grad T.
  KOKKOS_INLINE_FUNCTION void flux(int p, const double (&g)[D], double (&flow)[D]) const
  {
    const double* const F = &deformation(p, 0);
    const ThermoPoint at(tables, material(p), temperature(p));
    const double k = -(undeformed ? 1.0 : determinant<D>(F)) * volume(p) * at.conductivity();
    for (int d = 0; d < D; ++d)
      flow[d] = at.material.orthotropic ? 0.0 : k * g[d];
    if (!at.material.orthotropic)
      return;
    for (int e = 0; e < D; ++e)
    {
      double a[D], square = 0.0, along = 0.0;
      for (int d = 0; d < D; ++d)
      {
        a[d] = 0.0;
        for (int j = 0; j < D && !undeformed; ++j)
          a[d] += F[d * D + j] * axes(body(p), e, j);
        a[d] += undeformed ? axes(body(p), e, d) : 0.0;
        square += a[d] * a[d];
        along += a[d] * g[d];
      }
      for (int d = 0; d < D; ++d)
        flow[d] += k * at.material.ratio[e] * along / square * a[d];
    }
  }
};

template <int D>
ParticleFlux<D> particleFlux(const State<D>& state)
{
  const FieldTable& table = state.particles;
  return {state.materials.thermo,
          state.bodies.axes,
          table.scalar(fields::volume),
          table.scalar(fields::temperature),
          table.template real<gradientSize<D>>(fields::deformation),
          table.integer(fields::material),
          table.integer(fields::body),
          state.method.totalLagrangian};
}

} // namespace Rhegma::thermal
