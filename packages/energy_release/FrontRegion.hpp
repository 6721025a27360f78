#pragma once
/// The part of a body around a front from which particles are taken.

#include "energy_release/FrontLine.hpp"

namespace Rhegma::energy_release
{

/// A disk around a front in 2D.
struct Disk
{
  Vector<2> centre;
  double radius;

  KOKKOS_INLINE_FUNCTION bool holds(const Vector<2>& x) const
  {
    return dot(x - centre, x - centre) <= radius * radius;
  }
};

/// A box with its faces along the axes.
template <int D>
struct Region
{
  Vector<D> lower, upper;

  KOKKOS_INLINE_FUNCTION bool holds(const Vector<D>& x) const
  {
    bool in = true;
    for (int d = 0; d < D; ++d)
      in = in && x[d] >= lower[d] && x[d] <= upper[d];
    return in;
  }
};

/// The box around all nodes of a front with this much room on all sides [m].
Region<3> regionAround(const FrontLine& line, double room);

} // namespace Rhegma::energy_release
