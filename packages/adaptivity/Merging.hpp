#pragma once
/// Families of particles that are smaller than the cells around them are merged into one particle.

#include "state/State.hpp"

namespace Rhegma::adaptivity
{

/// What merging did.
struct Merged
{
  int families = 0;  ///< of all ranks
  int kept = 0;      ///< families that would have lost more energy than is allowed, of all ranks
  double lost = 0.0; ///< kinetic and strain energy of those of this rank [J]
};

/// Merges whole families (the 2^D parts of one particle) whose merged particle would touch no leaf of a
/// deeper level than its own, until there is none left; families on two sides of a crack are not merged.
/// Mass, volume now and before deformation and momentum are kept to round-off; stress and all that effects
/// add becomes the mean. Kinetic and strain energy fall: the loss is returned, for the energy balance. Leaves
/// the particles unsorted. Families whose parts are on several ranks are first moved to the rank of the first
/// part. Collective.
///
/// \param tolerance largest loss, or gain by rounding of a law with memory, as a fraction of what the family
/// holds or, where that is more, of what its mass would hold at the mean of all particles
template <int D>
Merged mergeParticles(State<D>& state, double tolerance);

} // namespace Rhegma::adaptivity
