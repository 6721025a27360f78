#pragma once
/// The rows of the mass matrix: which nodes have one, and what stands there before and after particles give.

#include "mass_matrix/ChooseRows.hpp"

namespace Rhegma::mass_matrix
{

/// Makes the rows of the nodes that particles couple now, and clears what particles give to.
template <int D>
void beginRows(const State<D>& state, const Unlumping& unlumping, MassSystem<D>& system);

/// Diagonals, so that rows add up to the lumped mass, and lists without their empty entries. Nodes that are
/// not coupled to others lose their rows.
template <int D>
void finishRows(const State<D>& state, MassSystem<D>& system);

} // namespace Rhegma::mass_matrix
