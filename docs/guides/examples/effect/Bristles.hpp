#pragma once

#include <plan/Effect.hpp>

/// The effect `Bristles`: elastic bristles on the nodes of the grid, which material that moves over them
/// bends.
Rhegma::EffectEntry bristles();
