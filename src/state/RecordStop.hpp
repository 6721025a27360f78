#pragma once
/// Fronts that stop for a numerical reason.

#include "state/State.hpp"

#include <string>

namespace Rhegma
{

/// Keeps the first stop of a front, or of nodes of it, for a numerical reason, and reports it in the warnings
/// of the run. \param state of the run \param front that stopped \param stop where, when and why \param
/// advice what helps, for the warning
template <int D>
void recordStop(State<D>& state, CrackFront<D>& front, const FrontEvent<D>& stop, const std::string& advice)
{
  if (front.stop.happened())
    return;
  front.stop = stop;
  state.warnings.push_back(frontName(state.cracks, front) + ": " + (D == 3 ? "a front node " : "") +
                           "stopped " + stop.asText() + advice);
}

} // namespace Rhegma
