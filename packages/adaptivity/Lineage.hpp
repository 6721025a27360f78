#pragma once
/// The fields that say which particle a part was split from.

#include "base/Field.hpp"

#include <string>

namespace Rhegma::adaptivity
{

/// Id of the particle of the start that a particle is part of.
inline const std::string ancestor = "ancestor";

/// Which part: D bits for every split, the last split lowest. Bit d is set in the upper half along the body's
/// axis d.
inline const std::string lineage = "lineage";

/// By how much a box may reach into leaves of a deeper level before the particle is too large for them, in
/// edges of the largest of these: boxes that end on the faces of leaves would otherwise split at the smallest
/// motion. Shape functions are exact for such boxes too. What is merged must keep clear of half of it, so
/// that it does not split again at once.
constexpr double mayReach = 0.05;

} // namespace Rhegma::adaptivity
