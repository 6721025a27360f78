#pragma once
/// Stored stencils: those of particles in this step, and those of points that are no particles.

#include "state/State.hpp"

namespace Rhegma
{

/// Fraction of the heaviest node around a point below which a node is left out of the motion of the point and
/// of forces on it. Where a particle's box overlaps a node's support by a fraction e of a cell, the mass of
/// the node is proportional to e^2 but its force to e, so its acceleration is meaningless. Particles weight
/// it with e^2; a point would use it fully.
constexpr double lightNode = 0.01;

/// Finds the particles that need stored stencils this step and makes them. Does nothing without an editor.
template <int D>
void storeStencils(State<D>& state);

/// Makes stencils of points (loads, crack faces) in rows 0 .. points.count - 1 of a table, of all nodes
/// around them on their side; none of points that all ranks list and another one owns.
template <int D>
void placeStencils(const State<D>& state, const ObservedPoints<D>& points, StencilTable<D>& table);

/// Copies the entries at nodes that have mass and renormalises them, so that no part of a load at the rim of
/// a body is lost; the two tables may be the same. \return number of points without any node with mass \param
/// lightest smallest fraction of the heaviest node around a point that counts as mass
template <int D>
int keepMassedNodes(const State<D>& state, int count, const StencilTable<D>& from, StencilTable<D>& to,
                    double lightest = lightNode);

/// pointStencils: makes the stencils of points and, if `massed` is set, keeps the nodes with mass only.
template <int D>
int pointStencils(const State<D>& state, const ObservedPoints<D>& points, StencilTable<D>& table, bool massed,
                  double lightest = lightNode);

} // namespace Rhegma
