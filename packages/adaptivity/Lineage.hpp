#pragma once
/// Where a particle comes from: which fields say so.

#include "state/Field.hpp"

#include <string>

namespace Rhegma::adaptivity
{

/// Id of the particle of the start that a particle is part of.
inline const std::string ancestor = "ancestor";

/// Which part: D bits for every split, the last split lowest. Bit d is set in the upper half along the body's
/// axis d.
inline const std::string lineage = "lineage";

} // namespace Rhegma::adaptivity
