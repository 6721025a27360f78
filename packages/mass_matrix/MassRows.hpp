#pragma once
/// The rows of the mass matrix: which nodes have one, and what stands there before and after particles give.

#include "mass_matrix/ChooseRows.hpp"

namespace Rhegma::mass_matrix
{

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

} // namespace Rhegma::mass_matrix
