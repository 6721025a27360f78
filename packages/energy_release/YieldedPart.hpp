#pragma once
/// Where a linear law does not see that its material yields.

#include "energy_release/FrontSample.hpp"
#include "energy_release/ToughnessReached.hpp"
#include "state/State.hpp"

#include <nlohmann/json.hpp>
#include <vector>

namespace Rhegma::energy_release
{

/// For each body with a linear law and a known yield stress, the largest von Mises stress as an answer, or as
/// a warning where more than a thousandth of the body has more than the yield stress. Particles within the
/// contours of the fronts are left out: there the stress of any crack is singular. Collective.
/// \param start at which stresses are judged
template <int D>
void reportYield(const State<D>& state, const std::vector<FrontSample<D>>& samples,
                 const ToughnessReached::Factors& start, nlohmann::json& summary);

} // namespace Rhegma::energy_release
