#pragma once
/// Cracks that become longer.

#include "cracks/Junctions.hpp"
#include "state/State.hpp"

namespace Rhegma
{
class Archive;
}

namespace Rhegma::cracks
{

/// Makes the advances that were asked of the fronts of a 2D scene (CrackSet::advances) and forgets them.
///
/// An advance adds a straight segment to its crack, whose faces start closed, and leaves the energy that the
/// new faces take in CrackFront::unspent for the cohesive force. Particles ahead of the old front that lay on
/// a side of the crack's straight continuation get their side anew where the crack turns.
///
/// A front that comes within half a cell of the surface of its body runs on to it and ends there. One that
/// comes closer than three cells to another crack that lies across its way, less than six cells ahead, runs
/// on to the first such crack too, ends on its face and is a junction from then on; the energy of that way is
/// booked as of any other. Two fronts in each other's way, within 15 degrees and six cells, meet: both end
/// where one is. One that comes as close to a crack beside its way, or to an earlier part of its own, halts:
/// cells can't tell such cracks apart. All are said once, in the warnings of the run. Belongs between steps.
void growCracks(State<2>& state, Junctions& junctions);

/// Saves or loads the vertices of the cracks and what their fronts have done.
template <int D>
void keepCracks(State<D>& state, Archive& archive);

} // namespace Rhegma::cracks
