#pragma once
/// Acceleration of the nodes around a front by internal forces.

#include "energy_release/FrontRegion.hpp"
#include "state/State.hpp"

namespace Rhegma::energy_release
{

/// Of each node, enriched fields included: acceleration [m/s2], then the mass to which it belongs [kg].
template <int D>
using NodalAcceleration = View<double * [D + 1]>;

/// Acceleration [m/s2] of nodes by internal forces, -sum_p V0 tau grad N / m, from the particles within
/// `radius` of a position, and by pressure on the faces of cracks (AccelerationByPressure.hpp); a row a node,
/// enriched fields included. Without other loads it is the nodes' acceleration. Where they act, such as
/// contact, body force or damping, it is less by what they do: used as `a` in the domain integrals it
/// accounts for their work. The mass m and N are those of the present positions: a node that a box just
/// reaches has a mass proportional to the square of the overlap and a force proportional to the overlap, so
/// that with the mass of the start of the step a small motion of the box would cause an arbitrary
/// acceleration.
NodalAcceleration<2> internalAcceleration(const State<2>& state, const Vector<2>& centre, double radius);

/// The same in reused rows, which grow if necessary.
void internalAcceleration(const State<2>& state, const Vector<2>& centre, double radius,
                          NodalAcceleration<2>& acceleration);

/// The same in 3D, from the particles in a box.
void internalAcceleration(const State<3>& state, const Region<3>& box, NodalAcceleration<3>& acceleration);

} // namespace Rhegma::energy_release
