#pragma once
/// Where a linear law does not see that its material yields.

#include "energy_release/FrontSample.hpp"
#include "state/State.hpp"

#include <string>
#include <vector>

namespace Rhegma::energy_release
{

/// A warning for each body with a linear law and a known yield stress, of which more than a thousandth has a
/// larger von Mises stress. Particles within the contours of the fronts are left out: there the stress of any
/// crack is singular. Collective. \param factor on all loads and stresses; 1: as they are at the end
template <int D>
std::vector<std::string> warningsOfYield(const State<D>& state, const std::vector<FrontSample<D>>& samples,
                                         double factor);

} // namespace Rhegma::energy_release
