#pragma once
/// Lists of the rows' entries that no band has: of nodes of refined cells and of enriched fields.

#include "mass_matrix/ChooseRows.hpp"

namespace Rhegma::mass_matrix
{

/// Initial capacity of a list. In refined cells, nodes of the finest cells have about as many neighbours as
/// on a lattice, nodes next to coarser cells some more. \param slots of a band
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

/// Doubles the capacity of hashed lists where one was full. \return whether it did: then all is to be added
/// again
template <int D>
bool growLists(MassSystem<D>& system);

} // namespace Rhegma::mass_matrix
