#pragma once
/// The particles around crack fronts that are unlumped.

#include "mass_matrix/MassSystem.hpp"

namespace Rhegma::mass_matrix
{

/// Lists the positions of all fronts: their vertices, so that in 3D a front is a line of positions; and the
/// radius and the edge of the zone around each. \param positions, zones grow if necessary \param count of the
/// positions
template <int D>
void listFronts(const State<D>& state, const Unlumping& unlumping, View<double* [D]>& positions,
                View<double* [2]>& zones, int& count);

/// theta: 1 inside the radius around a front, 0 beyond its edge, a cubic between with flat ends. The largest
/// of all fronts.
template <int D>
struct ConsistentFraction
{
  View<double* [D]> front;
  View<double* [2]> zone; ///< radius and edge of each [m]
  int numFronts;
  bool everywhere;

  KOKKOS_INLINE_FUNCTION double operator()(const double* x) const
  {
    if (everywhere)
      return 1.0;
    double largest = 0.0;
    for (int f = 0; f < numFronts; ++f)
    {
      double square = 0.0;
      for (int d = 0; d < D; ++d)
        square += (x[d] - front(f, d)) * (x[d] - front(f, d));
      const double edge = zone(f, 1), furthest = zone(f, 0) + edge;
      if (square > (1.0 + 1e-12) * furthest * furthest)
        continue;
      const double beyond = std::sqrt(square) - zone(f, 0);
      if (beyond <= 0.0)
        return 1.0;
      if (!(beyond < edge))
        continue;
      const double s = beyond / edge, fraction = 1.0 - s * s * (3.0 - 2.0 * s);
      largest = fraction > largest ? fraction : largest;
    }
    return largest;
  }

  /// Whether a particle of a block can be near enough. \param corner lowest cell along the cut axes
  KOKKOS_INLINE_FUNCTION bool reaches(const Grid<D>& grid, const int* corner) const
  {
    if (everywhere)
      return true;
    bool any = false;
    for (int f = 0; f < numFronts; ++f)
    {
      double square = 0.0;
      for (int a = 0; a < Blocks<D>::axes; ++a)
      {
        const int axis = grid.axisOrder[a];
        // Particles may have drifted a cell out of their block.
        const double low = corner[a] - 1.0, high = corner[a] + Blocks<D>::edge + 1.0;
        const double at = grid.inCells(front(f, axis), axis);
        const double apart = at < low ? low - at : at > high ? at - high : 0.0;
        square += apart * apart;
      }
      const double furthest = (zone(f, 0) + zone(f, 1)) * grid.inverse;
      any = any || square <= furthest * furthest;
    }
    return any;
  }
};

} // namespace Rhegma::mass_matrix
