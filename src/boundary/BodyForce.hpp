#pragma once
/// Forces that act on all mass.

#include "state/State.hpp"

namespace Rhegma
{

/// Adds m g to the force of every node [N]. \param acceleration g [m/s2]
template <int D>
void addBodyForce(const Nodes<D>& nodes, const Vector<D>& acceleration);

/// Work [J] of m g over the step, at the velocity that gives the particles their kinetic energy
/// (LoadVelocity).
template <int D>
double bodyForceWork(const State<D>& state, const Vector<D>& acceleration);

} // namespace Rhegma
