#pragma once
/// Supports that want two values of a node at once.

#include "boundary/Supports.hpp"

namespace Rhegma
{

/// What supports prescribe, in words.
struct Prescribed
{
  std::string name = "velocity"; ///< of the value
  std::string unit = "m/s";      ///< of the value
  bool hasAxes = true;           ///< whether it has components; else it is the first of them
};

/// Looks at the nodes that particles touch as they and the cells are now: two supports may hold one along the
/// same axis only if they want the same value, at all times of the run. Collective.
/// \return one sentence a pair that does not, naming both, the node and the values; empty where there is none
template <int D>
std::string contradictions(const std::vector<TimedConstraint<D>>& constraints, const State<D>& state,
                           double finalTime, const Prescribed& what = {});

} // namespace Rhegma
