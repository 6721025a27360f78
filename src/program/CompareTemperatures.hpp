#pragma once
/// Compares the temperatures of two runs.

#include "program/Comparison.hpp"

namespace Rhegma::program
{

/// Adds how far the peak rise of temperature moves from a run to one with half the cell size; of bodies that
/// are only cooled the largest fall instead. Nothing where a run has no heat.
/// \param asIs, half summaries of the runs
void compareTemperatures(Comparison& comparison, const nlohmann::json& asIs, const nlohmann::json& half);

} // namespace Rhegma::program
