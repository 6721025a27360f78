#pragma once
/// The forces of loads on their bodies, for the history and the summary.

#include "boundary/Loads.hpp"
#include "plan/Effect.hpp"

#include <memory>
#include <vector>

namespace Rhegma
{

/// The calls that report the whole force of each load, as a mean over the time since the last sample as that
/// of supports is (addReactions); in equilibrium as that of the last solution. Adds to what the effect
/// reports and remembers so far.
template <int D>
void addLoadForces(Effect<D>& effect, const std::shared_ptr<std::vector<Load<D>>>& loads);

} // namespace Rhegma
