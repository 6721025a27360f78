#pragma once
/// What fronts that run, or might have, tell the summary.

#include "propagation/FrontHistory.hpp"
#include "propagation/Options.hpp"
#include "state/State.hpp"

#include <nlohmann/json.hpp>

#include <vector>

namespace Rhegma::propagation
{

/// Says of a front that has not set out, after steps in which it might have, how near to it it came: in its
/// entry of the summary, as the share of what would start it, and in a sentence among the warnings. \param
/// closest of FrontHistory
template <int D>
void reportRest(const State<D>& state, const CrackFront<D>& front, double closest, nlohmann::json& summary);

/// When and how far a front ran: `runs` in its entry of the summary, and a sentence among the answers.
/// \param runs of FrontHistory, the last of which is over unless the front is running; in 3D one, of all
/// front nodes, whose length is not a number \param speed now [m/s]
template <int D>
void reportRuns(const State<D>& state, const CrackFront<D>& front, const std::vector<CrackRun>& runs,
                bool running, double speed, nlohmann::json& summary);

/// What became of the energy of new faces. \param taken by all fronts [J]
template <int D>
void reportEnergy(const State<D>& state, double taken, nlohmann::json& summary);

/// The energy release rate at which a front sets out, at the temperature of the start:
/// `propagation.initiation_toughness` [J/m2].
void reportToughness(const Options& options, nlohmann::json& summary);

} // namespace Rhegma::propagation
