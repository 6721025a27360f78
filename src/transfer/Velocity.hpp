#pragma once
/// Transfer of nodal motion to the particles' velocity, and of that velocity to the nodes.

#include "state/State.hpp"

namespace Rhegma
{

/// What to do in one pass over the particles.
enum class VelocityWhat
{
  Gather,          ///< change the particles' velocity
  Project,         ///< add m v of the particles to the nodes' projection
  GatherAndProject ///< the first, then the second with the new velocity (MUSL, USAVG)
};

/// Gather changes the particles' velocity by the nodes' acceleration (FLIP), mixed with the nodes' velocity
/// (PIC): v = (1 - f)(v + dt sum N a) + f sum N v_node, f the PIC fraction. Keeps momentum to round-off. The
/// kinetic energy that the fraction of PIC takes goes to EnergyBalance::filtered, on each rank its own.
/// Source: Brackbill and Ruppel, J. Comput. Phys. 65 (1986) 314.
///
/// Project adds N m v to the nodes' projection, which clearNodes or clearProjection has zeroed.
/// Source: Sulsky, Zhou and Schreyer, Comput. Phys. Commun. 87 (1995) 236.
template <int D>
void particleVelocity(State<D>& state, VelocityWhat what);

/// The nodes' projection from momentum to velocity.
template <int D>
void finishProjection(State<D>& state);

} // namespace Rhegma
