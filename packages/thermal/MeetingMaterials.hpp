#pragma once
/// Heat where several materials meet on the same nodes.
///
/// A node has one temperature, the mean of what its particles hold. Where two materials of unlike
/// temperatures meet it lies between them, and a body that conducts well draws heat from a node whose
/// temperature it does not have itself: it would fall below all temperatures around, for as long as the other
/// material takes to give up its part. So
///
/// - a material that conducts nothing has no part in nodes on which another one conducts: neither its
///   capacity nor its temperature is in them, and it takes none of their change;
/// - where several that conduct meet, their particles come together at the node's temperature as fast as heat
///   crosses a cell of the best conductor, at a rate of pi^2 D / h^2, that of the slowest mode of a slab of
///   h. What is drawn too much is bounded by that, however steps are:
///
/// A node of capacity C, of which a fraction s is the conductor's, has fallen short of the conductor's own
/// temperature by (1 - s) of the jump. Where the conductor reaches over a part a <= 1 of a cell next to it,
/// it holds a^2 h / 2 of it and passes a / h on to the next node, so the node follows that at a rate of s (2
/// / a) D / h^2, and a particle has no more than a fraction of a of that. Its temperature lags behind by the
/// rate over that of joining, a (2 / a) s (1 - s) / pi^2 <= 1 / (2 pi^2) of the jump, for each such node:
/// there is one where the joint runs along faces of cells, and there are two where it runs through cells.
///
/// Both rules leave all heat as it is, and the second a field alone that is linear in each cell.

#include "thermal/HeatNodes.hpp"

namespace Rhegma::thermal
{

/// Writes `meets` of the nodes. To be called before heat comes to them. Collective. \param fraction of the
/// way to the node's temperature that particles take where several materials that conduct meet, on top of
/// that of `changeToParticles`: both together are at most the whole way
template <int D>
void markMaterials(const State<D>& state, const HeatNodes<D>& nodes, double fraction);

/// Finds by how much each particle comes nearer to the nodes' temperature; `changeToParticles` gives it that.
/// To be called when the nodes' temperature is known, before the particles' gradients are renewed.
template <int D>
void joinMaterials(const State<D>& state, const HeatNodes<D>& nodes);

} // namespace Rhegma::thermal
