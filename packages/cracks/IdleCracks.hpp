#pragma once
/// Cracks that the cells are too coarse for.

#include "state/State.hpp"

namespace Rhegma::cracks
{

/// Warns of every crack that has no particle on one of its sides, and so has no effect: one that is shorter
/// than a cell may lie between two nodes, and one that is very close to a surface may lie beyond the last
/// particles. To be called once the particles next to the cracks have their sides.
template <int D>
void warnOfIdleCracks(State<D>& state);

} // namespace Rhegma::cracks
