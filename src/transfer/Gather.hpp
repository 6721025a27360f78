#pragma once
/// From the nodes: the particles' strain, stress and motion.

#include "state/State.hpp"

namespace Rhegma
{

/// Which nodal velocity strains and moves the particles.
enum class StrainVelocity
{
  Projection, ///< of the particles' own velocity: after the solve (MUSL) or before it (USF)
  Motion      ///< of the nodes after the solve (USL)
};

/// Moves particles by the nodes' velocity, strains them by its gradient L: F <- (I + dt L) F, and finds the
/// stress by each particle's law. The box of a particle follows F. With move = false only the strain happens,
/// with strain = false only the move.
///
/// One velocity does both, so that F is the exact derivative of the discrete motion: a rotating body keeps
/// its shape, and boxes that tile a body go on doing so. (With particles moved by the nodes' motion but
/// strained by the projection, which is smoother by up to a factor of four in waves of two cells, boxes of a
/// body in tension separated, and such waves grew without bound at a stress of a tenth of Young's modulus.)
/// The strain is over the fraction Clock::strainPass of the step, the move over all of it. \return the
/// largest wave speed plus particle speed [m/s]; infinite when a particle is inverted or not finite
template <int D>
double strainAndMove(State<D>& state, StrainVelocity velocity, bool strain, bool move);

} // namespace Rhegma
