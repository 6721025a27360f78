#pragma once
/// Cracks of 3D scenes that run.

#include "plan/Effect.hpp"

namespace Rhegma::propagation
{

/// As in 2D, with every front node of a front for itself (PropagationInSpace.cpp).
Effect<3> propagationInSpace(const Teuchos::ParameterList& scene, const RunOptions& run);

} // namespace Rhegma::propagation
