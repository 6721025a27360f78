#pragma once
/// Heat where several materials meet on the same nodes.
///
/// A node has one temperature, the mean of its particles. Where two materials of different temperatures meet
/// it lies between them, and a good conductor exchanges heat with a node of another temperature than its own:
/// it would fall below all temperatures around, until the other material has released its heat.
/// Therefore:
///
/// - an insulator does not contribute to nodes with a conductor: these have neither its capacity nor its
///   temperature, and it gets none of their change;
/// - where several conductors meet, the temperatures of their particles approach that of the node as fast as
///   heat crosses a cell of the best conductor, at a rate of pi^2 D / h^2, that of the slowest mode of a slab
///   of the thickness h. This bounds the excess for any time step:
///
/// A node of capacity C, of which a fraction s is the conductor's, has fallen short of the conductor's own
/// temperature by (1 - s) of the jump. Where the conductor reaches over a part a <= 1 of a cell next to it,
/// it holds a^2 h / 2 of it and passes a / h on to the next node, so the node follows that at a rate of s (2
/// / a) D / h^2, and a particle has no more than a fraction of a of that. Its temperature lags behind by the
/// rate over that of joining, a (2 / a) s (1 - s) / pi^2 <= 1 / (2 pi^2) of the jump, for each such node:
/// there is one where the joint runs along faces of cells, and there are two where it runs through cells.
///
/// Both rules conserve heat, and the second does not change a field that is linear in each cell.

#include "thermal/HeatNodes.hpp"

namespace Rhegma::thermal
{

/// Writes `meets` of the nodes. To be called before heat is added to them. Collective. \param fraction of the
/// difference to the temperature of the node by which particles approach it where several conductors meet, in
/// addition to that of `changeToParticles`; both together are at most 1
template <int D>
void markMaterials(const State<D>& state, const HeatNodes<D>& nodes, double fraction);

/// Finds the change of each particle towards the temperature of the nodes, which `changeToParticles` applies.
/// To be called when the nodes' temperature is known, before the particles' gradients are renewed.
template <int D>
void joinMaterials(const State<D>& state, const HeatNodes<D>& nodes);

} // namespace Rhegma::thermal
