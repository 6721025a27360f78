#pragma once
/// Stored stencils: which particles have one this step, and stencils of points that are no particles.

#include "state/State.hpp"

namespace Rhegma
{

/// Finds the particles that need stored stencils this step and makes them. Does nothing without an editor.
template <int D>
void storeStencils(State<D>& state);

/// Makes stencils of points (loads, crack faces) in rows 0 .. points.count - 1 of a table. Entries at nodes
/// without mass are dropped and the rest renormalised when `massed` is set, so that a load at the rim of a
/// body is never lost. \return the number of points none of whose nodes has mass
template <int D>
int pointStencils(const State<D>& state, const ObservedPoints<D>& points, StencilTable<D>& table,
                  bool massed);

} // namespace Rhegma
