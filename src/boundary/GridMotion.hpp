#pragma once
/// A grid that moves with a support: which scenes may have one.

#include "boundary/Supports.hpp"

#include <vector>

namespace Rhegma
{

/// Checks the support with which the grid moves, if there is one, and widens the boxes of others that span
/// the domain along the axes of the motion to all of space, since the domain moves. The other supports must
/// do so or move alike, because the nodes in a box that stands still would change from step to step. \param
/// constraints the supports of the scene \param state with the lattice at the start \param cellsChange
/// whether cells refine or coarsen in the run \throws std::invalid_argument
template <int D>
void prepareGridMotion(std::vector<TimedConstraint<D>>& constraints, const State<D>& state, bool cellsChange);

} // namespace Rhegma
