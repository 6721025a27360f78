#pragma once
/// Supports that want a node to move in two ways at once.

#include "boundary/Supports.hpp"

namespace Rhegma
{

/// Looks at the nodes of the lattice that particles touch as they are now: two supports may hold one along
/// the same axis only if they want the same velocity, at all times of the run. Collective.
/// \return one sentence a pair that does not, naming both, the node and the values; empty where there is none
template <int D>
std::string contradictions(const std::vector<TimedConstraint<D>>& constraints, const State<D>& state,
                           double finalTime);

} // namespace Rhegma
