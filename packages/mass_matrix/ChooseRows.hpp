#pragma once
/// Which nodes have a row where only particles around crack fronts are unlumped.

#include "mass_matrix/Fronts.hpp"

namespace Rhegma::mass_matrix
{

/// Reach of the coupling: number of neighbours along an axis, on each side, with which a node may have a
/// particle in common.
inline int reachOf(ShapeKind shape) { return shape == ShapeKind::Linear ? 1 : 2; }

constexpr int chosen = -2; ///< in rowOf: a node that shall have a row

/// Which fraction of a particle's mass is consistent, with the fronts as they were listed last.
template <int D>
ConsistentFraction<D> consistentFraction(const Unlumping& unlumping, const MassSystem<D>& system)
{
  return {system.front, system.zone, system.numFronts, unlumping.everywhere};
}

/// Marks the nodes that particles in the zones around fronts can touch, as the fronts were listed last;
/// the same shared ones on all ranks. Collective.
template <int D>
void chooseAroundFronts(const State<D>& state, const Unlumping& unlumping, const MassSystem<D>& system);

/// No more rows than this are needed: nodes of the grid, hardly more than particles where each fills a cell,
/// and with Partial those near fronts, in two fields.
template <int D>
double largestRows(const State<D>& state, const Unlumping& unlumping);

} // namespace Rhegma::mass_matrix
