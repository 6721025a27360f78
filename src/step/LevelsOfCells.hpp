#pragma once
/// Levels of the cells that are refined at the start, for the particles of bodies.

#include "geometry/Seeds.hpp"
#include "state/State.hpp"

namespace Rhegma
{

/// Whether any particle is only a part of a lattice cell: at edges of bodies that are no boxes, and at
/// cracks.
template <int D>
bool haveCutParticles(const State<D>& state);

/// The deepest level of cells that a box touches, as the particle that fills it would; the cells are those of
/// the state now.
template <int D>
IsDivided<D> dividedByCells(const State<D>& state);

} // namespace Rhegma
