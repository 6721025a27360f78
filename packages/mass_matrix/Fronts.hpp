#pragma once
/// Which particles a crack front unlumps.

#include "state/State.hpp"

namespace Rhegma::mass_matrix
{

/// Lists the places of all fronts: their vertices, so that in 3D a front is a line of places.
/// \param places grows where there are more than it holds \param count of the places
template <int D>
void listFronts(const State<D>& state, View<double* [D]>& places, int& count);

/// theta: 1 inside the radius around a front, 0 beyond its edge, a cubic between with flat ends.
template <int D>
struct ConsistentShare
{
  View<double* [D]> front;
  int numFronts;
  bool everywhere;
  double radius, edge;

  KOKKOS_INLINE_FUNCTION double operator()(const double* x) const
  {
    if (everywhere)
      return 1.0;
    double nearest = 1e300;
    for (int f = 0; f < numFronts; ++f)
    {
      double square = 0.0;
      for (int d = 0; d < D; ++d)
        square += (x[d] - front(f, d)) * (x[d] - front(f, d));
      nearest = square < nearest ? square : nearest;
    }
    const double beyond = std::sqrt(nearest) - radius;
    if (beyond <= 0.0)
      return 1.0;
    if (!(beyond < edge))
      return 0.0;
    const double s = beyond / edge;
    return 1.0 - s * s * (3.0 - 2.0 * s);
  }

  /// Whether a particle of a block can be near enough. \param corner lowest cell along the cut axes
  KOKKOS_INLINE_FUNCTION bool reaches(const Grid<D>& grid, const int* corner) const
  {
    if (everywhere)
      return true;
    const double zone = (radius + edge) * grid.inverse;
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
      any = any || square <= zone * zone;
    }
    return any;
  }
};

} // namespace Rhegma::mass_matrix
