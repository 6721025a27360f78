#pragma once
/// Cells from which particles may touch a node that another group touches.

#include "state/State.hpp"

namespace Rhegma::body_contact
{

/// By the lowest node of a cell.
struct MeetingCells
{
  /// Lowest and highest group that has particles in the cell; then the same within some cells along axes.
  View<int*[2]> own, around, next;
  View<char*> meets; ///< not 0 where another group is in reach of the particles of the cell
};

/// Finds the cells of marked blocks in which particles of several groups may touch the same node: a particle
/// touches the nodes of its cell, and with GIMP also the next ones on both sides. \param nearBlock as in
/// SharedNodes
template <int D>
void findMeetingCells(const State<D>& state, const View<char*>& nearBlock, MeetingCells& cells);

} // namespace Rhegma::body_contact
