#pragma once
/// Warnings about fronts at the end of a run.

#include "propagation/FrontHistory.hpp"
#include "propagation/FrontState.hpp"
#include "propagation/Options.hpp"
#include "state/State.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace Rhegma::propagation
{

/// The largest G of a front that was never initiated, over its initiation toughness.
struct Closest
{
  double release = 0.0; ///< from AdvanceRule::startTime on
  double early = 0.0;   ///< before it, of the samples that there were
};

/// How close a front that has not initiated came to initiation, in its entry and in a warning; also by the
/// largest hoop stress (HoopStress.hpp), where that is known. With K_Ic, which Options may have, as an
/// intensity, too. \param rule at the start
template <int D>
void reportRest(const State<D>& state, const CrackFront<D>& front, const Closest& closest,
                const AdvanceRule& rule, const Options& options, nlohmann::json& summary);

/// Warns where G of the history was not that by which growth was found, which may have another contour.
void compareContours(const std::string& name, const ContourDifference& largest, nlohmann::json& summary);

} // namespace Rhegma::propagation
