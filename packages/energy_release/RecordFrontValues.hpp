#pragma once
/// Values along fronts for the output.

#include "energy_release/FrontSample.hpp"
#include "state/State.hpp"

#include <vector>

namespace Rhegma::energy_release
{

/// Sets Sample::fronts of a state in 3D to the values along its fronts. In 2D there is nothing to do: all
/// values are in the history.
/// \param samples of all fronts \param options whether domain integrals are computed
void recordFrontValues(State<2>& state, const std::vector<FrontSample<2>>& samples, const Options& options);
void recordFrontValues(State<3>& state, const std::vector<FrontSample<3>>& samples, const Options& options);

} // namespace Rhegma::energy_release
