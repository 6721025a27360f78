#pragma once
/// Loads whose direction and size depend on where the faces of cracks are.

#include "state/State.hpp"

namespace Rhegma
{

/// Whether forces act on the faces of cracks: a pressure, or that of closed faces on each other. A step of
/// equilibrium applies them where the faces are at its start. \param state of the run
template <int D>
bool loadsFollowFaces(const State<D>& state)
{
  return state.cracks.pressure.extent(0) > 0 || static_cast<bool>(state.cracks.tractions);
}

} // namespace Rhegma
