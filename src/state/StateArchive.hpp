#pragma once
/// The state of a run in a checkpoint.

#include "archive/Archive.hpp"
#include "state/State.hpp"

namespace Rhegma
{

/// Saves or loads what the core knows from step to step: time and step, energies, particles, refined cells.
///
/// The particles are one table a field in the order of their ids, and leaves have names that depend on no
/// order, so that any number of ranks and any back end can take them. The order in which a run had its
/// particles and blocks is next to them, in the group "order": sums in another order have other last digits.
/// It is used where it fits (Archive::sameOrder); else particles are sorted anew.
///
/// \param state when loading, one that the same scene has initialised
template <int D>
void archiveState(State<D>& state, Archive& archive);

/// Saves or loads the nodal fields of effects by the identities of their nodes, once the state and the
/// cracks' formulation are there. Collective.
template <int D>
void archiveNodalFields(State<D>& state, Archive& archive);

} // namespace Rhegma
