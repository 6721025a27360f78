#pragma once
/// The rows of the mass matrix: the nodes that have one, and its content before and after particles are
/// added.

#include "mass_matrix/ChooseRows.hpp"

namespace Rhegma::mass_matrix
{

/// Makes the rows of the nodes that particles couple now, and clears the matrix.
template <int D>
void beginRows(const State<D>& state, const Unlumping& unlumping, MassSystem<D>& system);

/// Diagonals, so that rows add up to the lumped mass, and lists without their empty entries. Nodes that are
/// not coupled to others lose their rows.
template <int D>
void finishRows(const State<D>& state, MassSystem<D>& system);

} // namespace Rhegma::mass_matrix
