#pragma once
/// Parts of nodes in the contact of a tool: the force acts where the surface is, between rows of nodes.

#include "rigid_tools/ToolContacts.hpp"

#include <vector>

namespace Rhegma::rigid_tools
{

/// Finds the nodes among which each contact divides its impulse: those of the cell in which its point of the
/// surface lies, by the linear functions of the cell, so that the work of the impulse is that of a force at
/// this point. A node alone would take all of it, and the stress in the row of cells at the face would be
/// that force over the part of the cell that the body fills. Leaves out contacts further inside the tool than
/// half a cell, whose point another one has too. Where cells are refined, or nodes have several fields, the
/// contact keeps its own node. \param centre of rotation of the tool, now [m]
template <int D>
void divideContacts(const State<D>& state, const Vector<D>& centre, ToolContacts<D>& contacts);

/// Velocity of the body at the point of a contact, of nodal values whose first D columns it is. [m/s]
template <int D, class Velocity>
KOKKOS_INLINE_FUNCTION Vector<D> velocityAt(const ToolContacts<D>& contacts, int c, const Velocity& velocity)
{
  Vector<D> sum{};
  for (int e = 0; e < contacts.parts(c); ++e)
    for (int d = 0; d < D; ++d)
      sum[d] += contacts.part(c, e) * velocity(contacts.partRow(c, e), d);
  return sum;
}

/// Gives contacts their own node again where another tool has one of their nodes, so that impulses of tools
/// at the same nodes settle as those of single nodes do. \param all of all tools
template <int D>
void separateTools(const State<D>& state, const std::vector<ToolContacts<D>*>& all);

/// Marks the axes along which a support holds the node of a contact or one among which it is divided, and
/// takes them out of its normal. The last step of listing contacts: what holds them depends on how they are
/// divided.
template <int D>
void holdContacts(const State<D>& state, const ToolContacts<D>& contacts);

} // namespace Rhegma::rigid_tools
