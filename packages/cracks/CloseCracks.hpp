#pragma once
/// Cracks that the cells between them do not separate.

#include "state/State.hpp"

namespace Rhegma::cracks
{

/// Refuses two cracks that are somewhere nearer to each other than three cells of the size there: each node
/// has a side of one crack. To be called once the first cells are refined.
///
/// Throws std::invalid_argument with the section's path.
template <int D>
void refuseCloseCracks(const State<D>& state);

/// Stops the run where cracks of bodies that are kept apart have come as near to each other, as these bodies
/// move.
template <int D>
void stopCracksThatMeet(State<D>& state);

} // namespace Rhegma::cracks
