#pragma once
/// The disk around a front over which the domain integrals run.

#include "state/State.hpp"

namespace Rhegma::energy_release
{

struct ContourRadii
{
  double inner; ///< the weight is 1 up to here [m]
  double outer; ///< and 0 from here on [m]
};

/// The weight q of the domain integrals. It is evaluated at nodes only and interpolated by the grid's
/// functions, so that the integrals are sums over nodal residual forces: evaluated at particles it gives
/// errors of tens of percent.
template <int D>
struct NodalWeight
{
  Grid<D> grid;
  Vector<D> centre;
  ContourRadii radii;

  KOKKOS_INLINE_FUNCTION double operator()(int node) const
  {
    const double r = norm(grid.nodePosition(node) - centre);
    const double q = (radii.outer - r) / (radii.outer - radii.inner);
    return q > 1.0 ? 1.0 : (q > 0.0 ? q : 0.0);
  }
};

/// Radius [m] up to which every node around `centre` is surrounded by material, at most `radius`. A node
/// counts as surrounded when its share of the particles' volume is above 0.6 cells: half a cell is what a
/// node on a straight surface has.
template <int D>
double clearRadius(const State<D>& state, const Vector<D>& centre, double radius);

/// Largest outer radius around a front that stays inside the body and clear of other fronts, at most
/// `radius` [m].
template <int D>
double largestContour(const State<D>& state, const CrackFront<D>& front, double radius);

} // namespace Rhegma::energy_release
