#pragma once
/// Explicit cracks.

#include "plan/Effect.hpp"

namespace Rhegma::cracks
{

/// The effect `Cracks`: cuts the body along polylines (2D) or flat polygons (3D) that move with the material.
EffectEntry cracksEntry();

} // namespace Rhegma::cracks
