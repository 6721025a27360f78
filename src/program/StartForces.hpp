#pragma once
/// Forces of loads and supports as the first crack starts.

#include <nlohmann/json.hpp>

#include <string>

namespace Rhegma::program
{

/// Adds `forces_at_start` to a summary of equilibrium: for each load and support the components of its force
/// on its body as the first crack starts [N], in 2D that of the thickness of the scene; null where a support
/// does not hold. That of a static run of linear bodies is its force at the end times
/// `start_of_growth.factor_at_end`; of a run by load factor, and of one that compares G with a toughness,
/// that of the history, between its rows on straight lines. Nothing is added where no crack starts, in
/// motion, and where the history has no row at that time. \param history path of its history.csv
void addStartForces(nlohmann::json& summary, const std::string& history);

/// The largest of these forces by name: "forces as the first crack starts: Grip 55.85 N"; empty without any.
std::string startForcesAsText(const nlohmann::json& summary);

} // namespace Rhegma::program
