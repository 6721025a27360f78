#pragma once
/// Lists of the rows' entries that no band has: of nodes of refined cells and of second fields.

#include "mass_matrix/ChooseRows.hpp"

namespace Rhegma::mass_matrix
{

/// Entries for which a list has room at first. In refined cells a node of the smallest ones meets about as
/// many others as on a lattice, one next to larger cells some more. \param slots of a band
template <int D>
int listCapacityOf(int slots, bool refined);

/// The kind of the lists: hashed where cells are refined, else a position for each slot in either field.
template <int D>
void chooseLists(bool refined, MassSystem<D>& system);

/// Gives lists to the rows of nodes that stored stencils touch, and clears them.
template <int D>
void startLists(const State<D>& state, const ConsistentFraction<D>& fractionAt, MassSystem<D>& system);

/// Most entries of a list.
template <int D>
int fullestListOf(const MassSystem<D>& system);

/// Gives hashed lists twice the room where one was full. \return whether it did: then all is to be added anew
template <int D>
bool growLists(MassSystem<D>& system);

} // namespace Rhegma::mass_matrix
