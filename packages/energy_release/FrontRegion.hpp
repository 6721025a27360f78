#pragma once
/// The part of a body around a front from which particles are taken.

#include "energy_release/FrontLine.hpp"
#include "transfer/BlocksInReach.hpp"

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

template <int D>
using Region = AxisBox<D>;

/// The box around all nodes of a front with this much room on all sides [m].
Region<3> regionAround(const FrontLine& line, double room);

/// Cells along each axis from a particle to the furthest of its nodes.
template <int D>
double reachOfStencils(const State<D>& state);

/// The box of the nodes that particles in a box touch.
template <int D>
Region<D> nodesOf(const State<D>& state, const Region<D>& box);

} // namespace Rhegma::energy_release
