#pragma once
/// The rows of the mass matrix: which nodes have one, and what stands there before and after particles give.

#include "mass_matrix/Fronts.hpp"
#include "mass_matrix/MassSystem.hpp"

namespace Rhegma::mass_matrix
{

/// Which share of a particle's mass is consistent, with the fronts as they were listed last.
template <int D>
ConsistentShare<D> consistentShare(const Unlumping& unlumping, const MassSystem<D>& system)
{
  return {system.front, system.zone, system.numFronts, unlumping.everywhere};
}

/// Makes the rows of the nodes that particles couple now, and clears what particles give to.
template <int D>
void beginRows(const State<D>& state, const Unlumping& unlumping, MassSystem<D>& system);

/// Entries for which a list has room at first. In refined cells a node of the smallest ones meets about as
/// many others as on a lattice, one beside larger cells some more. \param slots of a band
template <int D>
int listRoomOf(int slots, bool refined);

/// Gives hashed lists twice the room where one was full. \return whether it did: then all is to be added anew
template <int D>
bool growLists(MassSystem<D>& system);

/// Diagonals, so that rows add up to the lumped mass, and lists without their empty entries. Nodes that are
/// not coupled to others lose their rows.
template <int D>
void finishRows(const State<D>& state, MassSystem<D>& system);

/// No more rows than this are needed: nodes of the grid, hardly more than particles where each fills a cell,
/// and with Partial those near fronts, in two fields.
template <int D>
double largestRows(const State<D>& state, const Unlumping& unlumping);

} // namespace Rhegma::mass_matrix
