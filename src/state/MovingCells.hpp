#pragma once
/// A grid that moves with a support.

#include "state/State.hpp"

namespace Rhegma
{

class Archive;

/// Moves the lattice, and with it the domain, by Mesh::ahead; each rank its part of it. Cells keep their
/// numbers. Particles must not be further outside of their blocks after it than these allow: strainAndMove
/// checks that. Cells that are refined can't be moved: std::logic_error. Call it between two steps.
template <int D>
void moveCells(State<D>& state);

/// Saves or loads where the lattice is. Loading needs the whole lattice on each rank.
template <int D>
void archiveCells(State<D>& state, Archive& archive);

} // namespace Rhegma
