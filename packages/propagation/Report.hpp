#pragma once
/// Report of fronts and of the energy of their new faces, for the summary.

#include "propagation/FrontState.hpp"
#include "propagation/Options.hpp"

#include <nlohmann/json.hpp>

#include <vector>

namespace Rhegma::propagation
{

/// The entries of all fronts: whether each runs, when it initiated and arrested, its path (2D); a warning of
/// each that has not initiated; and the energy of new faces. Where a stop of a front ends the run
/// (Options::endsAtStops), `ended_by` is why, and what to change. Of growth under given loads in equilibrium,
/// `propagation.not_stopped` has the fronts that would grow further, and an answer says so.
template <int D>
void reportFronts(const State<D>& state, const std::vector<FrontState<D>>& fronts, const Options& options,
                  nlohmann::json& summary);

/// The energy release rate at which a front initiates, at the temperature of the start:
/// `propagation.initiation_toughness` [J/m2].
void reportToughness(const Options& options, nlohmann::json& summary);

} // namespace Rhegma::propagation
