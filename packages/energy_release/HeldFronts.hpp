#pragma once
/// What a run says of fronts that have not advanced: G and K.

#include "energy_release/FrontSample.hpp"

#include <vector>

namespace Rhegma::energy_release
{

/// Adds to `answers` of a summary a line for each front that has a value of G and has neither advanced nor
/// ended, such as "crack Notch, front 0: G = 134.7 +- 0.6 J/m2 (0.45 %), K_I = 20.1 +- 0.1 kPa m^0.5, K_II =
/// 0 +- 100 Pa m^0.5 at t = 4 ms", with errors where they can be estimated, and a line for each reason why
/// they can't; in 3D means and ranges along the front. Where K_I is negative it says how much of G would
/// advance the crack: K_II^2 + K_III^2 over the sum of all squares. Where an earlier sample had a larger G,
/// it says which. Of many fronts those with the largest G. \param time of the samples [s]
template <int D>
void addAnswersOfHeldFronts(const CrackSet<D>& set, const std::vector<FrontSample<D>>& samples, double time,
                            nlohmann::json& summary);

} // namespace Rhegma::energy_release
