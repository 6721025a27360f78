#pragma once
/// Corrected broken cells whose temperatures can be unstable (docs/explanation/broken-cells.md).

#include "plan/RunOptions.hpp"

#include <Teuchos_ParameterList.hpp>

#include <string>
#include <vector>

namespace Rhegma::cracks
{

/// Messages on bodies with one particle per cell and heat next to cracks with extrapolated shape functions:
/// gradients of temperature can grow with each step. \param scene validated
std::vector<std::string> bodiesOfFewParticles(const Teuchos::ParameterList& scene, const RunOptions& options);

} // namespace Rhegma::cracks
