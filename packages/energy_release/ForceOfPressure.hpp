#pragma once
/// What pressure on the faces of cracks adds to the forces of nodes.

#include "state/State.hpp"

namespace Rhegma::energy_release
{

/// Whether anything presses on the faces of cracks (CrackSet::pressure).
template <int D>
bool isPressed(const State<D>& state);

/// Force on the nodes by the pressure on the faces [N], a row a node, enriched fields included; no rows where
/// nothing presses. With it the acceleration in the integrals around a front is without the work of the
/// pressure on nodes: near a front the two faces have nodes in common, on which opposite forces cancel, and
/// u_i,k is singular there. That work is added as it follows from the faces (FaceTractions.hpp,
/// FacePressureWork.hpp). Collective.
template <int D>
View<double* [D]> forceOfPressure(const State<D>& state);

} // namespace Rhegma::energy_release
