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

/// How much of a box beyond a row of nodes is left out.
enum class Clipping
{
  LittleBeyondCells, ///< up to `leastReach` of its width
  ToOneCell          ///< all that is beyond the cell of its centre
};

/// Part of a box beyond a row of nodes that Clipping::LittleBeyondCells leaves out. The stiffness that such a
/// part gives to the nodes there is its square, a tenth of what the ghost penalty gives to them at least.
constexpr double leastReach = 0.01;

/// Part of its stiffness that Clipping::ToOneCell leaves to a node at least. Conjugate gradients that are
/// preconditioned with the stiffness of such boxes take a third more iterations in a turned block of 20
/// cells; with a tenth of this part, another tenth.
constexpr double leastStiffness = 0.5;

/// The boxes of a state with its stencils; empty with linear functions, and where no box is clipped. Where
/// nodes would lose what holds them, the boxes that reach them stay as they are along the axes in which they
/// do: with LittleBeyondCells, nodes that particles see only by what would be left out, and with ToOneCell
/// all to which it would leave less than `leastStiffness`. Collective.
template <int D>
ClippedBoxes<D> clipBoxes(const State<D>& state, Clipping clipping);

/// Whether so many boxes reach over rows of nodes that a stiffness of boxes in one cell has far fewer
/// couplings: more than a third of all. Collective.
template <int D>
bool spanSeveralCells(const State<D>& state);

} // namespace Rhegma::equilibrium
