#pragma once
/// Transfer of particles between ranks.

#include "parallel/Division.hpp"
#include "state/State.hpp"

#include <vector>

namespace Rhegma
{

/// Rank that owns the cell of each particle.
template <int D>
std::vector<int> ownersOf(const State<D>& state, const Division<D>& division);

/// Drops all particles but those with numbers `stay`, in that order.
template <int D>
void keepParticles(State<D>& state, const std::vector<int>& stay);

/// Sends each particle to the rank `owner`. Collective.
template <int D>
void sendParticles(State<D>& state, const std::vector<int>& owner);

} // namespace Rhegma
