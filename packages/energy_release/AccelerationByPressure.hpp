#pragma once
/// What pressure on the faces of cracks adds to the acceleration of nodes by internal forces.

#include "energy_release/InternalAcceleration.hpp"

namespace Rhegma::energy_release
{

/// Whether anything presses on the faces of cracks (CrackSet::pressure).
template <int D>
bool isPressed(const State<D>& state);

/// Adds the acceleration by the pressure to that by internal forces, so that the integrals around a front are
/// without the work of the pressure on nodes: near a front the two faces have nodes in common, on which
/// opposite forces cancel, and u_i,k is singular there. That work is added as it follows from the faces
/// (PressedPath.hpp, FacePressureWork.hpp). Collective.
template <int D>
void addAccelerationByPressure(const State<D>& state, const NodalAcceleration<D>& acceleration);

} // namespace Rhegma::energy_release
