#pragma once
/// What a run tells of the gas in its cracks.

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

/// Writes what summary.json has of the gas: its state and where its mass and energy came from and went to.
/// Collective.
template <int D>
void reportGas(const State<D>& state, const BurnState<D>& burn, nlohmann::json& summary);

} // namespace Rhegma::combustion
