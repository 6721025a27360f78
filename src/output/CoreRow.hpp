#pragma once
/// Energies and momentum of all particles, and their columns in the history.

#include "state/State.hpp"

#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>

namespace Rhegma
{

/// Computes the energy balance and the momentum, and inserts their columns before those of the row.
///
/// Always kinetic, strain, external_work, residual, momentum_x..; `plastic` where a material can flow;
/// tools, thermal, heat, damped, contact, fracture, merged and combustion only where an effect of the scene
/// contributes to them. \param given columns of the scene's effects (Effect::balance)
template <int D>
void coreRow(State<D>& state, const std::set<std::string>& given);

/// `energy` (every entry of the energy balance, zero where no effect contributes to it; `plastic` where a
/// material can flow) and `momentum` of summary.json, as last measured. What only samples measure is not a
/// number after steps of which none was sampled.
template <int D>
void coreReport(const State<D>& state, nlohmann::json& summary);

} // namespace Rhegma
