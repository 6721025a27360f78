#pragma once
/// Particles that are parts of larger ones: fields that say of which, and when a particle is too large.

#include "state/State.hpp"

#include <string>
#include <vector>

namespace Rhegma
{

namespace fields
{

/// Id of the particle of the start that a particle is part of.
inline const std::string ancestor = "ancestor";

/// Which part: D bits for every split, the last split lowest. Bit d is set in the upper half along the body's
/// axis d.
inline const std::string lineage = "lineage";

} // namespace fields

/// By how much a box may reach into leaves of a deeper level before the particle is too large for them, in
/// edges of the largest of these: boxes that end on the faces of leaves would otherwise split at the smallest
/// motion. Shape functions are exact for such boxes too. What is merged must keep clear of half of it, so
/// that it does not split again at once.
constexpr double mayReach = 0.05;

} // namespace Rhegma
