#pragma once
/// Boxes of particles that reach hardly beyond a row of nodes, for the stiffness of large systems.

#include "state/State.hpp"

namespace Rhegma::equilibrium
{

/// Positions and boxes of particles from which the stiffness of large systems is assembled. A box that
/// reaches over a row of nodes by less than `leastReach` of its width ends there: particles that a load step
/// has moved by a thousandth of a cell would else couple each node with 125 in place of 27, for a change of
/// the stiffness of that size. Forces are those of the particles as they are, so that the equilibrium is the
/// same; Newton's method converges linearly, with a factor of the order of `leastReach`. Stencils of boxes
/// represent linear displacements whatever their ends are, so that rigid motions still have no energy.
template <int D>
struct ClippedBoxes
{
  View<double* [D]> position; ///< [m]; empty where boxes are used as they are
  View<double* [D]> half;     ///< half widths [m]

  bool any() const { return position.extent(0) > 0; }

  /// Replaces positions and boxes of a connectivity (transfer/Connectivity.hpp), if there are any.
  template <class Connect>
  Connect in(Connect connect) const
  {
    if (any())
    {
      connect.position = position;
      connect.box = half;
    }
    return connect;
  }
};

/// Part of a box beyond a row of nodes that is left out. The stiffness that such a part gives to the nodes
/// there is its square, a tenth of what the ghost penalty gives to them at least.
constexpr double leastReach = 0.01;

/// The boxes of a state with their stencils; empty with linear functions, and where no box is clipped. Nodes
/// that particles see only by what would be left out keep these particles' boxes, so that every row of the
/// stiffness has its couplings. Collective.
template <int D>
ClippedBoxes<D> clipBoxes(const State<D>& state);

} // namespace Rhegma::equilibrium
