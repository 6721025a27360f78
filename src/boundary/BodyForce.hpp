#pragma once
/// Forces that act on all mass.

#include "grid/Nodes.hpp"

namespace Rhegma
{

/// Adds m g to the force of every node [N]. \param acceleration g [m/s2]
template <int D>
void addBodyForce(const Nodes<D>& nodes, const Vector<D>& acceleration);

/// Work [J] of m g over dt, from the mean of old and new velocity.
template <int D>
double bodyForceWork(const Nodes<D>& nodes, const Vector<D>& acceleration, double dt);

} // namespace Rhegma
