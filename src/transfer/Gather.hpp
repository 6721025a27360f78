#pragma once
/// Nodes to particles.

#include "state/State.hpp"

namespace Rhegma
{

/// Changes the particles' velocity by the nodes' acceleration (FLIP), mixed with the nodes' velocity (PIC):
/// v = (1 - f)(v + dt sum N a) + f sum N v_node, f the PIC fraction.
/// Keeps momentum to round-off.
/// Source: Brackbill and Ruppel, J. Comput. Phys. 65 (1986) 314.
template <int D>
void gatherVelocity(State<D>& state);

/// Zeroes the nodes' projection.
template <int D>
void clearProjection(State<D>& state);

/// The nodes' projection from momentum to velocity.
template <int D>
void finishProjection(State<D>& state);

/// Which nodal velocity strains the particles.
enum class StrainVelocity
{
  Projection, ///< MUSL: of the particles' new velocity
  Motion      ///< USL and USF: of the nodes' velocity, old (USF) or new (USL)
};

/// Moves particles by the nodes' velocity, strains them by its gradient L: F <- (I + dt L) F, and finds the
/// stress by each particle's law. The box of a particle follows F. With move = false only the strain happens,
/// with strain = false only the move.
///
/// F is the exact derivative of the discrete motion when both use one velocity, so a rotating body keeps its
/// shape: no stress grows (the step's chord is part of the motion that F sees). \return the largest wave
/// speed plus particle speed [m/s]; infinite when a particle is inverted or not finite
template <int D>
double strainAndMove(State<D>& state, StrainVelocity velocity, bool strain, bool move);

} // namespace Rhegma
