#pragma once
/// Numbers that show at a glance where a run stands, from a row of its history.

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Rhegma
{

/// The energy release rates of the fronts in a row that have one, in their order: of the J integral, in 3D
/// the largest of the nodes [J/m2]. \param row names and values
std::vector<double> releasesOf(const std::vector<std::pair<std::string, double>>& row);

/// How far cracks have come, in a row.
struct CrackExtents
{
  std::vector<double> sizes; ///< lengths of cracks up to their fronts [m], in 3D areas of cracks [m2]
  bool areAreas = false;
};
CrackExtents extentsOf(const std::vector<std::pair<std::string, double>>& row);

/// The residual of the energy balance over the largest of its entries; none where all are zero or the row has
/// no balance. \param row names and values
std::optional<double> residualFraction(const std::vector<std::pair<std::string, double>>& row);

/// Names of the entries of the energy balance that a row may have, without the residual, the largest first in
/// plots.
const std::vector<std::string>& energyNames();

} // namespace Rhegma
