#pragma once
/// Numbers that show at a glance where a run stands, from a row of its history.

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Rhegma
{

/// The largest energy release rate of the fronts in a row: of the J integral, in 3D of all nodes [J/m2]; none
/// where no front has a value. \param row names and values
std::optional<double> largestRelease(const std::vector<std::pair<std::string, double>>& row);

/// The residual of the energy balance over the largest of its entries; none where all are zero or the row has
/// no balance. \param row names and values
std::optional<double> residualFraction(const std::vector<std::pair<std::string, double>>& row);

/// Names of the entries of the energy balance that a row may have, without the residual, the largest first in
/// plots.
const std::vector<std::string>& energyNames();

} // namespace Rhegma
