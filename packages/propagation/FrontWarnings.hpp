#pragma once
/// Warnings about fronts at the end of a run.

#include "state/State.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace Rhegma::propagation
{

/// How close a front that has not initiated came to initiation, in its entry and in a warning.
template <int D>
void reportRest(const State<D>& state, const CrackFront<D>& front, double closest, double startTime,
                nlohmann::json& summary);

/// Warns where G of the history is not that by which growth was found, which may have another contour.
/// \param release of the latter [J/m2] \param entry of the front
void compareContours(const std::string& name, double release, const nlohmann::json& entry,
                     nlohmann::json& summary);

} // namespace Rhegma::propagation
