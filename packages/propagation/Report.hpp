#pragma once
/// What fronts that run, or might have, tell the summary.

#include "state/State.hpp"

#include <nlohmann/json.hpp>

namespace Rhegma::propagation
{

/// Says of a front that never set out how near to it it came: in its entry of the summary, as the share of
/// what would start it, and in a sentence among the warnings. \param closest of FrontHistory
template <int D>
void reportRest(const State<D>& state, const CrackFront<D>& front, double closest, nlohmann::json& summary);

/// What became of the energy of new faces. \param taken by all fronts [J]
template <int D>
void reportEnergy(const State<D>& state, double taken, nlohmann::json& summary);

} // namespace Rhegma::propagation
