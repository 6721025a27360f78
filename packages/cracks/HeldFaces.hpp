#pragma once
/// Supports that hold both faces of a crack next to them.

#include "cracks/Sides.hpp"
#include "state/State.hpp"

namespace Rhegma::cracks
{

/// Warns where a support holds the enriched field of nodes whose crack runs along it: the material across the
/// crack is not supported, but its stencils reach the node, so the crack can't open there. Belongs after
/// nodes have their masses.
template <int D>
void warnOfHeldFaces(State<D>& state, const Surroundings& surroundings);

} // namespace Rhegma::cracks
