#pragma once
/// Growth of cracks and the loads that it took, from the history of a run.

#include "program/CompareRuns.hpp"

namespace Rhegma::program
{

/// Whether a history has areas of cracks, as in 3D.
bool growsByArea(const HistoryColumns& history);

/// How far all fronts together have come since the first row of a history [m], or by how much the areas of
/// all cracks have grown [m2], row by row; empty without fronts.
std::vector<double> growthOf(const HistoryColumns& history);

/// The factor of the loads at a growth, as of `growthOf`, on straight lines between rows; not a number
/// where loads have no factor, and beyond the last row. \param growth positive
double factorAt(const HistoryColumns& history, double growth);

} // namespace Rhegma::program
