#pragma once
/// Plastic zones at fronts by the K that a run computed.

#include "energy_release/FrontSample.hpp"
#include "energy_release/ToughnessReached.hpp"
#include "state/State.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace Rhegma::energy_release
{

/// Adds `plastic_zone` to the entry of each front whose material has a yield stress: twice Irwin's radius (K
/// / yield stress)^2 / (2 pi), in plane strain and in 3D a third of it [m], with K = sqrt(E' G) of the
/// largest G of the run, in 3D of all nodes; null where that is not known. Warns where it is more than a
/// fifth of the crack or of the ligament, and of a law that flows where it exceeds the outer radius of the
/// domain integral. Source: Irwin (1960); ASTM E399 for the sizes. Collective. \param start factor on the
/// loads at which K is judged \param estimate a warning of a scene before its first step, for
/// `warnings_of_a_check`; empty: none \param summary with the entries of the samples
template <int D>
void reportPlasticZones(const State<D>& state, const std::vector<FrontSample<D>>& samples,
                        const ToughnessReached::Factors& start, const std::string& estimate,
                        nlohmann::json& summary);

} // namespace Rhegma::energy_release
