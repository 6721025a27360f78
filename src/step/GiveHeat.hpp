#pragma once
/// Heat that an application adds to the particles between two steps.

#include "state/State.hpp"

#include <vector>

namespace Rhegma
{

/// Adds heat to the particles of this rank, at constant strain, and records it as `heat` of the energy
/// balance. Their internal energy rises by as much, their temperature by heat over capacity, as by
/// conduction.
///
/// \param joules of each particle, in the order of the fields [J]; negative: heat is removed Throws
/// std::invalid_argument, and changes nothing, where the scene has no heat, where the number of values is not
/// that of the particles, or where one is not finite.
template <int D>
void giveHeat(State<D>& state, const std::vector<double>& joules);

} // namespace Rhegma
