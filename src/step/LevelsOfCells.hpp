#pragma once
/// Levels of the cells that are refined at the start, for the particles of bodies.

#include "geometry/Seeds.hpp"
#include "state/State.hpp"

#include <Teuchos_ParameterList.hpp>

namespace Rhegma
{

/// Whether bodies of a scene have particles at their edges that are parts of lattice cells: all but boxes.
bool haveCutParticles(const Teuchos::ParameterList& scene);

/// The deepest level of cells that a box touches, as the particle that fills it would; the cells are those of
/// the state now.
template <int D>
IsDivided<D> dividedByCells(const State<D>& state);

} // namespace Rhegma
