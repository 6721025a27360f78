#pragma once
/// Particles that are larger than the cells around them become 2^D smaller ones.

#include "state/State.hpp"

namespace Rhegma::adaptivity
{

/// Splits every particle whose box (its position, for linear functions) touches a leaf of a deeper level than
/// its own into 2^D at +- 1/4 of its edges, and those again, until none is too large.
///
/// The parts take equal fractions of mass and volume and copy velocity, deformation gradient, stress and all
/// that effects add: mass, momentum, angular momentum and energy are kept to round-off, and the boxes tile
/// what the box of the whole covered (where its edges lie along the axes). The first part keeps the
/// particle's id. Leaves the particles unsorted. Collective. \return how many particles all ranks have added
template <int D>
int splitParticles(State<D>& state);

} // namespace Rhegma::adaptivity
