#pragma once
/// Forces and stiffness of particles on the nodes that they see.

#include "equilibrium/Unknowns.hpp"

namespace Rhegma::equilibrium
{

/// Values of unknowns, D * row + axis.
using Values = View<double*>;

/// force -= internal forces of the particles for a trial displacement over the step [N].
/// \param displacement [m] \return false where a particle is inverted
template <int D>
bool subtractInternalForce(const State<D>& state, const RowGraph& graph, const Values& displacement,
                           const Values& force);

/// force -= internal forces of the stress that the particles have before the step [N], which is not that of
/// the law where temperatures have changed since.
template <int D>
void subtractStoredForce(const State<D>& state, const RowGraph& graph, const Values& force);

/// Blocks of D x D numbers for each entry of RowGraph::column: the derivative of the internal forces [N/m].
using StiffnessBlocks = View<double*>;

/// Adds the particles' stiffness at a trial displacement. \param boxes in place of those of the particles, if
/// any \return false where a particle is inverted
template <int D>
bool addStiffness(const State<D>& state, const RowGraph& graph, const Values& displacement,
                  const ClippedBoxes<D>& boxes, const StiffnessBlocks& stiffness);

} // namespace Rhegma::equilibrium
