#pragma once
/// Impulses between a tool and the fields of nodes that touch it.

#include "rigid_tools/ToolContacts.hpp"

namespace Rhegma::rigid_tools
{

/// What a tool has exchanged with bodies in a step.
template <int D>
struct ToolSums
{
  Vector<D> impulse{};     ///< on the bodies [N s]
  double dissipated = 0.0; ///< kinetic energy that contact took [J]
  double friction = 0.0;   ///< the part of it along the faces [J]
  double work = 0.0;       ///< of the tool on the bodies [J]
  double overlap = 0.0;    ///< largest, of domains that press on the tool [m]
  int closed = 0;          ///< fields of nodes that press on it
  int cut = 0;             ///< how many of them slide with less friction than the tool's law has
};

/// Changes the nodes' motion by impulses of a tool on the fields that touch it and would move into it, and
/// records them. They are such that both move alike along the normal, and along the face too where friction
/// bears it. The velocity of a tool with a mass is found with them (FreeVelocity.hpp), so that its momentum
/// changes by exactly the opposite of their sum. Counts in `cut` contacts with too little friction.
///
/// Called several times a step where several tools touch one field: then it finds the impulses of this tool
/// anew, with those of the others as they are. \return the largest change of an impulse, as a fraction of the
/// largest impulse
template <int D>
double exchangeImpulses(const State<D>& state, Tool<D>& tool, ToolContacts<D>& contacts);

/// Finds the energy that the impulses of a tool take and its work, before any tool has changed the projection
/// that strains the particles: the particles' kinetic energy changes by the impulse times the mean of the
/// node's velocities before and after the step, and the tool does the impulse times the mean of its
/// velocities as work.
template <int D>
void countImpulses(const State<D>& state, const Tool<D>& tool, const ToolContacts<D>& contacts);

/// Gives the fields that press on a tool its velocity along the normal in this projection, and along the face
/// too where they stick. Adds the work that the other forces on the node do by the change to the energy
/// taken.
///
/// Called several times a step where several tools press on one field. \return the largest change of a
/// velocity [m/s]
template <int D>
double joinProjection(const State<D>& state, const Tool<D>& tool, const ToolContacts<D>& contacts);

/// Sums over the contacts of a tool.
template <int D>
ToolSums<D> sumContacts(const ToolContacts<D>& contacts);

} // namespace Rhegma::rigid_tools
