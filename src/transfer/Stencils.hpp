#pragma once
/// Stored stencils: which particles have one this step, and stencils of points that are no particles.

#include "state/State.hpp"

namespace Rhegma
{

/// Fraction of the heaviest node around a point below which a node is too light to follow or to push faces
/// with. Where a particle's box touches a node's support by a fraction e of a cell, its mass goes with e^2
/// but its force with e, so its acceleration means nothing. The particles see it with weight e^2; a point
/// would see it whole.
constexpr double lightNode = 0.01;

/// Finds the particles that need stored stencils this step and makes them. Does nothing without an editor.
template <int D>
void storeStencils(State<D>& state);

/// Makes stencils of points (loads, crack faces) in rows 0 .. points.count - 1 of a table, of all nodes
/// around them on their side; none of points that all ranks list and another one owns.
template <int D>
void placeStencils(const State<D>& state, const ObservedPoints<D>& points, StencilTable<D>& table);

/// Copies the entries at nodes that have mass and renormalises them, so that a load at the rim of a body is
/// never lost; the two tables may be one. \return the number of points none of whose nodes has mass \param
/// lightest fraction of the heaviest node around a point from which a node counts as having mass
template <int D>
int keepMassedNodes(const State<D>& state, int count, const StencilTable<D>& from, StencilTable<D>& to,
                    double lightest = lightNode);

/// Both in one table; without the second unless `massed` is set.
template <int D>
int pointStencils(const State<D>& state, const ObservedPoints<D>& points, StencilTable<D>& table, bool massed,
                  double lightest = lightNode);

} // namespace Rhegma
