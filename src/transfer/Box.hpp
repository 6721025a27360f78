#pragma once
/// The box of a particle, over which GIMP averages the shape functions.

#include "base/Types.hpp"

namespace Rhegma
{

/// Half widths [m] of the axis-parallel box that has the particle's second moments: half = sqrt(sum_i (F
/// E_i)_d^2) / 2, E_i the undeformed edge vectors.
///
/// Exact for any stretch along the axes and for quarter turns; a turned square keeps its size, and the boxes
/// of a body under uniform stretch tile it. At most half a cell in each direction, so that a box touches at
/// most two cells along an axis. \param F deformation gradient; null: undeformed \param axes undeformed edge
/// directions of each body \param edge undeformed edge lengths [m]
template <int D>
KOKKOS_INLINE_FUNCTION void updateBox(const View<double* [D][D]>& axes, int body, const double* edge,
                                      const double* F, double largest, double* half)
{
  double square[D] = {};
  for (int e = 0; e < D; ++e)
    for (int i = 0; i < D; ++i)
    {
      double component = 0.0;
      for (int j = 0; j < D && F != nullptr; ++j)
        component += F[i * D + j] * axes(body, e, j);
      component += F == nullptr ? axes(body, e, i) : 0.0;
      component *= edge[e];
      square[i] += component * component;
    }
  for (int d = 0; d < D; ++d)
  {
    const double width = 0.5 * std::sqrt(square[d]);
    half[d] = width < largest ? width : largest;
  }
}

} // namespace Rhegma
