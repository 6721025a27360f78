#pragma once
/// What a run says of its cracks and fronts.

#include "cracks/OverlapRecord.hpp"
#include "state/State.hpp"

#include <nlohmann/json.hpp>

#include <vector>

namespace Rhegma::cracks
{

/// Adds the columns of cracks to the sample: largest opening [m], in 3D the area [m2], and where cracks grow
/// the fraction of the nodes of each front that have stopped. \param openings of the cracks (openingsOf)
template <int D>
void addCrackColumns(State<D>& state, const std::vector<Opening>& openings, bool grows);

/// Adds the entries of cracks and fronts to the summary, and warnings of faces that overlap, or have done so.
/// \param overlaps of the run so far, of each crack \param touching contact keeps faces apart, so that none
/// do \param startsInEquilibrium as by Time > Initial State = Equilibrium
template <int D>
void reportCracks(const State<D>& state, const std::vector<OverlapRecord>& overlaps, bool grows,
                  bool touching, bool startsInEquilibrium, nlohmann::json& summary);

} // namespace Rhegma::cracks
