#pragma once
/// The displacement of nodes by that of the particles around them.

#include "energy_release/InternalAcceleration.hpp"

namespace Rhegma::energy_release
{

/// Of each node, enriched fields included: displacement [m], then the mass that it was averaged over [kg].
template <int D>
using NodalDisplacements = View<double * [D + 1]>;

///     u_I = sum_p m_p N_I (u_p + (1 - F_p^-1) (x_I - x_p)) / sum_p m_p N_I
///
/// over the particles in a range. It is exact for a displacement that is linear on the node's side of a
/// crack, also for nodes that have particles on one side only; an average without the slope would be that of
/// the particles' centre. Collective.
NodalDisplacements<2> displacementOfNodes(const State<2>& state, const Disk& range);
NodalDisplacements<3> displacementOfNodes(const State<3>& state, const Region<3>& range);

/// Jump of the displacement from side -1 to side +1 of a crack [m] at positions on it, the same on all ranks.
/// Positions without a node with material on one side have none. Collective.
template <int D>
std::vector<Vector<D>> openingAt(const State<D>& state, const NodalDisplacements<D>& displacement, int crack,
                                 const std::vector<Vector<D>>& positions);

/// Stencils of positions on the faces of side -1 of a crack, then on those of side +1, of nodes with mass.
template <int D>
StencilTable<D> stencilsOnFaces(const State<D>& state, int crack, const std::vector<Vector<D>>& positions);

} // namespace Rhegma::energy_release
