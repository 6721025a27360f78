#pragma once
/// Supports that prescribe different values of one node.

#include "boundary/Supports.hpp"

namespace Rhegma
{

/// The prescribed quantity, for messages.
struct Prescribed
{
  std::string name = "velocity"; ///< of the value
  std::string unit = "m/s";      ///< of the value
  bool hasAxes = true;           ///< whether it has components; else it is the first of them
};

/// Checks the nodes that particles touch now: two supports may hold a node along the same axis only if they
/// prescribe the same value at all times of the run. Collective.
/// \return a line for each pair that contradicts, with the node and the values; empty where there is none
template <int D>
std::string contradictions(const std::vector<TimedConstraint<D>>& constraints, const State<D>& state,
                           double finalTime, const Prescribed& what = {});

} // namespace Rhegma
