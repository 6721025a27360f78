#pragma once
/// Report of the gas in cracks.

#include "combustion/BurnState.hpp"

#include <nlohmann/json.hpp>

namespace Rhegma::combustion
{

/// Mass of the particles of all ranks [kg]. Collective.
template <int D>
double massOfParticles(const State<D>& state);

/// Writes a sample of history.csv (Sample::row).
template <int D>
void sampleGas(State<D>& state, const BurnState<D>& burn);

/// Writes the gas to summary.json: its state, and the balances of its mass and energy. Collective.
template <int D>
void reportGas(const State<D>& state, const BurnState<D>& burn, nlohmann::json& summary);

} // namespace Rhegma::combustion
