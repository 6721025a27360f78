#pragma once
/// What is wrong with temperatures where a law finds no stress for them.

#include "state/State.hpp"

#include <string>

namespace Rhegma
{

/// A sentence on the coldest particle of this rank if it is at or below absolute zero, or on thermal
/// strain that leaves nothing of a particle; empty where there is no heat or both are sound.
template <int D>
std::string heatFailure(const State<D>& state);

} // namespace Rhegma
