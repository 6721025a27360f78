#pragma once
/// The state of a scene that is only checked, for programs that draw it.

#include "Simulation.hpp"
#include "parallel/Ranks.hpp"

#include <nlohmann/json.hpp>
#include <string>

namespace Rhegma::program
{

/// Writes fields.h5, the particles, cells and cracks before any step, and check.json: the report of the
/// simulation and, as `loads`, the lines of --check on the resultants of loads. Collective.
/// \param folder new or empty \param simulation that has taken no step \param summary its report
/// \param loads lines of text Throws std::invalid_argument where the folder holds anything or can't be made,
/// and OutputError where files can't be written
void writeCheckedState(const std::string& folder, Simulation& simulation, nlohmann::json summary,
                       const std::string& loads, const Ranks& ranks);

} // namespace Rhegma::program
