#pragma once
/// Failures of laws that are due to temperatures.

#include "state/State.hpp"

#include <string>

namespace Rhegma
{

/// Message on the coldest particle of this rank if it is at or below absolute zero, or on thermal strain that
/// shrinks a particle to nothing; empty without heat or without such a failure.
template <int D>
std::string heatFailure(const State<D>& state);

} // namespace Rhegma
