#pragma once
/// The traction at points on the faces.

#include "transfer/FacePoints.hpp"

namespace Rhegma::contact
{

/// Traction on side +1 at a point [Pa].
template <int D>
KOKKOS_INLINE_FUNCTION Vector<D> tractionAt(const FacePoints<D>& points, const View<double*>& pressure,
                                            const View<double * [D - 1]>& shear, int k)
{
  Vector<D> traction;
  for (int d = 0; d < D; ++d)
    traction[d] = pressure(k) * points.normal(k, d);
  for (int t = 0; t < D - 1; ++t)
    traction = traction - shear(k, t) * tangentOf(points, k, t);
  return traction;
}

} // namespace Rhegma::contact
