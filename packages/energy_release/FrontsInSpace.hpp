#pragma once
/// The effect Energy Release for 3D scenes.

#include "plan/Effect.hpp"

namespace Rhegma::energy_release
{

/// J and stress intensities along the fronts of 3D scenes, in the history as means and extremes, in the
/// summary at every front node.
Effect<3> fronts3(const Teuchos::ParameterList& scene, const RunOptions& run);

} // namespace Rhegma::energy_release
