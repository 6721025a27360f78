#pragma once
/// The files of fields and fronts that a run continues after a checkpoint.

#include "Simulation.hpp"
#include "parallel/Ranks.hpp"

#include <string>
#include <vector>

namespace Rhegma::program
{

/// Continues fields.h5 and fronts.h5 as the checkpoint left them. One that can't be continued is renamed.
/// Throws OutputError where it can't be. Collective. \param scene validated \param simulation that has loaded
/// the checkpoint \param folder of the output \param ranks of the run; the first of them renames \return
/// warnings for the user
std::vector<std::string> continueOutput(const Teuchos::ParameterList& scene, Simulation& simulation,
                                        const std::string& folder, const Ranks& ranks);

} // namespace Rhegma::program
