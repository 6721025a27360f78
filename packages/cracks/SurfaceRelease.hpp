#pragma once
/// The cohesive forces of nodes that 3D fronts have passed.

#include "cracks/Sides.hpp"
#include "state/State.hpp"

namespace Rhegma::cracks
{

template <int D>
class CrackGrowth;

/// Gives nodes that wait for their cohesive force (Cohesion.hpp) one, as FrontTies::release does in 2D.
///
/// The nodes that a step opens next to a front node share the energy of the area that they stand for,
///
///     E = Gc sum s dx^2 / n (1 - z),
///
/// Gc of the front node, s the share of a full node's mass that the node has, as little at a surface, n the
/// largest component of the normal and z the distance from the crack along that axis in cells, so that the
/// nodes of a column stand for the column. These areas add up to the crack's, and as they need not do so in
/// every step, E is by up to half more or less, so that what the front has booked and the nodes have not yet
/// taken (CrackFront::unspent) stays near zero.
///
/// \param whole forces of all ranks on nodes; empty where there is one rank
void releaseBehind(const CrackGrowth<3>& growth, State<3>& state, const Surroundings& surroundings,
                   const View<double* [3]>& whole, const View<double* [3]>& jump,
                   const View<double* [7]>& cohesive);

} // namespace Rhegma::cracks
