#pragma once
/// Nodes that fronts pass or leave again: the energy that they get from the front, and return to it.

#include "cracks/FrontSprings.hpp"
#include "cracks/NearestFront.hpp"
#include "cracks/NodalSprings.hpp"
#include "cracks/Sides.hpp"
#include "state/State.hpp"

namespace Rhegma::cracks
{

/// Gives each node that a front passes in this step (NodalSprings::isPassed) a cohesive traction, and adds it
/// to the nodal forces.
///
/// The nodes next to one front node divide an energy by their holding forces, all with one range
/// (CohesiveLaw.hpp). In 2D that energy is all that the front has pending (ReleaseBudget::releaseAll). In 3D
/// it is that of the area of the nodes,
///
///     E = Gc sum s dx^2 / n (1 - z),
///
/// Gc of the front node, s the fraction of a full node's mass that the node has, as little at a surface, n
/// the largest component of the normal and z the distance from the crack along that axis in cells, so that
/// the nodes of a column stand for the column. These areas add up to that of the crack, and as they need not
/// do so in every step, E is by up to half more or less, so that the pending energy stays near zero.
///
/// Belongs after all other forces on nodes are known. Collective.
template <int D>
void releasePassedNodes(State<D>& state, const Surroundings& surroundings, const NodalSprings<D>& springs,
                        const ToughnessAlong<D>& toughness);

/// Returns the pending energy of nodes that have one field again to the nearest front that has grown:
/// smoothing may move a 3D front back by a part of a cell. Collective. \param stamp number of the step
template <int D>
void returnPendingEnergy(State<D>& state, const NodalSprings<D>& springs, const NearestFront<D>& frontOf,
                         int stamp);

/// The same for nodes that were removed by coarsening. Collective.
template <int D>
void returnPendingOfLostNodes(State<D>& state, int stamp);

} // namespace Rhegma::cracks
