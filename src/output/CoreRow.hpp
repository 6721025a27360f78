#pragma once
/// Energies and momentum of all particles, and their columns in the history.

#include "state/State.hpp"

#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>

namespace Rhegma
{

/// Measures, and puts the columns of the energy balance and of the momentum in front of those that the row
/// has.
///
/// Always kinetic, strain, external_work, residual, momentum_x..; `plastic` where a material can flow;
/// thermal, heat, damped, contact, fracture, merged and combustion only where an effect of the scene gives
/// them. \param given columns that the scene's effects give (Effect::balance)
template <int D>
void coreRow(State<D>& state, const std::set<std::string>& given);

/// `energy` (every entry of the energy balance, zero where no effect gives it; `plastic` where a material can
/// flow) and `momentum` of summary.json, as last measured.
template <int D>
void coreReport(const State<D>& state, nlohmann::json& summary);

} // namespace Rhegma
