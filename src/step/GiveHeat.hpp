#pragma once
/// Heat that an application gives to the particles between two steps.

#include "state/State.hpp"

#include <vector>

namespace Rhegma
{

/// Adds heat to the particles of this rank, at constant strain, and energy balance it in the energy balance's
/// `heat`. What they hold rises by just as much; their temperature by heat over capacity, as conduction has
/// it rise.
///
/// \param joules of each particle, in the order of the fields [J]; less than 0 takes heat away
/// Throws std::invalid_argument, and changes nothing, where nobody carries heat, where there are more or
/// fewer numbers than particles, or where one is not finite.
template <int D>
void giveHeat(State<D>& state, const std::vector<double>& joules);

} // namespace Rhegma
