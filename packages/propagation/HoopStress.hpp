#pragma once
/// Start of fronts under shear by the largest hoop stress, next to that by G of a straight extension. In 2D.

#include "propagation/FrontState.hpp"
#include "propagation/Options.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace Rhegma::propagation
{

/// Marks fronts at rest whose stress intensities are computed in this step of motion (CrackFront::measured):
/// those whose G is so large that the largest hoop stress may be what it is at the toughness, or larger than
/// it was. In equilibrium all are computed.
void markMeasured(State<2>& state, const Options& options, const std::vector<FrontState<2>>& fronts);
void markMeasured(State<3>& state, const Options& options, const std::vector<FrontState<3>>& fronts);

/// Records HoopStart of fronts that were never initiated and whose intensities are known: under loads with a
/// factor that of the first state, else the largest from the start time on.
void recordHoopStart(const State<2>& state, const Options& options, std::vector<FrontState<2>>& fronts);
void recordHoopStart(const State<3>& state, const Options& options, std::vector<FrontState<3>>& fronts);

/// Adds what is recorded to the entry of a front (docs/explanation/crack-growth.md).
void reportHoopStart(const State<2>& state, const Options& options, const FrontState<2>& own,
                     nlohmann::json& entry);
void reportHoopStart(const State<3>& state, const Options& options, const FrontState<3>& own,
                     nlohmann::json& entry);

/// What shear does to the load at which a front starts, such as "it turned by 41 degrees as it started, for
/// which the largest hoop stress needs about 0.87 of the load"; empty below half a per cent, and where it is
/// not known. \param front its entry in the summary, with `first_turn` and `hoop_stress_load`
std::string effectOfShear(const nlohmann::json& front);

/// The same of the factor of the loads at which cracks start, of all fronts of a summary: the first of them
/// to start, or one that did not start with it and starts at a lower load by the largest hoop stress; empty
/// or with a separator in front. \param factor at which the first front starts by G
std::string effectOfShearOnFactor(double factor, const nlohmann::json& summary);

/// The same of a front that was never initiated, after the text on its G; empty where it is not known or less
/// than half a per cent. \param front its entry in the summary
std::string effectOfShearAtRest(const nlohmann::json& front);

/// The same of the first front that was initiated, with a separator in front. \param summary of all fronts
std::string effectOfShearOnFirst(const nlohmann::json& summary);

} // namespace Rhegma::propagation
