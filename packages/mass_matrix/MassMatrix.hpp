#pragma once
/// The mass matrix of the nodes: lumped, full, partly unlumped, or its inverse as a series.

#include "plan/Effect.hpp"

namespace Rhegma::mass_matrix
{

/// The effect `Mass Matrix`.
EffectEntry massMatrixEntry();

} // namespace Rhegma::mass_matrix
