#pragma once
/// Supports that hold both faces of a crack beside them.

#include "cracks/Sides.hpp"
#include "state/State.hpp"

namespace Rhegma::cracks
{

/// Warns where a support holds the second field of nodes whose crack runs along it: what lies across the
/// crack is not the support's, but the node is in its stencils, and the crack can't open there. To be called
/// once nodes have their masses.
template <int D>
void warnOfHeldFaces(State<D>& state, const Surroundings& surroundings);

} // namespace Rhegma::cracks
