#pragma once
/// Positions of the nodes that particles touch.

#include "state/State.hpp"

#include <vector>

namespace Rhegma
{

/// Positions of the nodes near the particles of this rank [m], as particles and cells are now: those of the
/// lattice that the particles would touch if no cell were refined, and those of refined cells that they do.
template <int D>
std::vector<Vector<D>> touchedNodes(const State<D>& state);

} // namespace Rhegma
