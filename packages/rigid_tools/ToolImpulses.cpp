#include "rigid_tools/ToolImpulses.hpp"

#include "base/SmallLoops.hpp"
#include "rigid_tools/ContactParts.hpp"
#include "rigid_tools/ContactsInOrder.hpp"
#include "rigid_tools/FreeVelocity.hpp"

#include <algorithm>
#include <vector>

namespace Rhegma::rigid_tools
{

namespace
{

/// The impulse of a contact if the tool moves with a velocity.
template <int D>
struct ImpulseOf
{
  Nodes<D> nodes;
  ToolContacts<D> contacts;
  FrictionLaw law;
  RigidVelocity<D> tool;

  KOKKOS_INLINE_FUNCTION ContactImpulse<D> operator()(int c) const
  {
    const double mass = contacts.mass(c);
    const Vector<D> n = vectorAt<D>(contacts.normal, c), velocity = velocityAt(contacts, c, nodes.motion);
    if (!(mass > 0.0) || !(dot(n, n) > 0.0))
      return {};
    const Vector<D> surface = tool.at(vectorAt<D>(contacts.arm, c));
    Vector<D> alike;
    for (int d = 0; d < D; ++d)
      alike[d] = contacts.held(c, d) != 0 ? 0.0 : contacts.impulse(c, d) + mass * (surface[d] - velocity[d]);
    return contactImpulse(law, n, alike);
  }
};

/// Finds the impulses of a tool whose velocity is known.
template <int D>
struct FindImpulses
{
  ImpulseOf<D> of;

  KOKKOS_INLINE_FUNCTION void operator()(const int c) const
  {
    const ContactImpulse<D> contact = of(c);
    of.contacts.sticks(c) = contact.sticks ? 1 : 0;
    for (int d = 0; d < D; ++d)
      of.contacts.wanted(c, d) = contact.impulse[d];
  }
};

/// The fields that a tool with a mass may press on, for the host, with the contacts in the order of rows.
template <int D>
std::vector<FieldAtTool<D>> fieldsAtTool(const Nodes<D>& nodes, const ToolContacts<D>& contacts)
{
  const ToolContacts<D> at = contacts;
  const View<double * [2 * D + 1]> packed("rhegma::fieldsAtTool", contacts.count);
  const View<char* [D]> held("rhegma::heldFieldsAtTool", contacts.count);
  parallelForSmall(
      "rhegma::packFieldsAtTool", contacts.count, KOKKOS_LAMBDA(const int c) {
        const double mass = at.mass(c);
        const Vector<D> velocity = velocityAt(at, c, nodes.motion);
        packed(c, 2 * D) = mass;
        for (int d = 0; d < D; ++d)
        {
          packed(c, d) = at.normal(c, d);
          packed(c, D + d) = mass > 0.0 ? velocity[d] - at.impulse(c, d) / mass : 0.0;
          held(c, d) = at.held(c, d);
        }
      });
  const auto host = onHost(packed);
  const auto hostHeld = onHost(held);
  std::vector<FieldAtTool<D>> fields(contacts.count);
  for (int c = 0; c < contacts.count; ++c)
  {
    fields[c].mass = host(c, 2 * D);
    for (int d = 0; d < D; ++d)
    {
      fields[c].normal[d] = host(c, d);
      fields[c].velocity[d] = host(c, D + d);
      fields[c].free[d] = hostHeld(c, d) == 0;
    }
  }
  return fields;
}

/// Finds the impulses of a tool with a mass. \param alone its velocity without them [m/s] \return contacts
/// with less friction than the law has
template <int D>
int findImpulsesOfMass(const Nodes<D>& nodes, const Tool<D>& tool, const ToolContacts<D>& contacts,
                       const Vector<D>& alone)
{
  MovingMass<D> mass;
  mass.mass = tool.mass().mass;
  mass.alone = alone;
  mass.guess = tool.velocity().ofCentre;
  mass.law = tool.law();
  for (int d = 0; d < D; ++d)
    mass.moves[d] = tool.moves(d);
  const FreeVelocity<D> found = findFreeVelocity(mass, fieldsAtTool(nodes, contacts));
  const auto wanted = Kokkos::create_mirror_view(contacts.wanted);
  const auto sticks = Kokkos::create_mirror_view(contacts.sticks);
  for (int c = 0; c < contacts.count; ++c)
  {
    sticks(c) = found.contacts[c].sticks ? 1 : 0;
    for (int d = 0; d < D; ++d)
      wanted(c, d) = found.contacts[c].impulse[d];
  }
  Kokkos::deep_copy(contacts.wanted, wanted);
  Kokkos::deep_copy(contacts.sticks, sticks);
  return found.cut;
}

/// Changes of impulses in a sweep over contacts.
struct Changes
{
  double changed = 0.0; ///< the largest [N s]
  double largest = 0.0; ///< the largest impulse [N s]
};

/// Applies the impulses that are wanted, in the order of the contacts, so that sums do not depend on the
/// threads: contacts next to each other have nodes in common.
template <int D>
struct ApplyImpulses
{
  Nodes<D> nodes;
  ToolContacts<D> contacts;
  double dt;
  double fraction; ///< of the change

  KOKKOS_INLINE_FUNCTION void apply(int c, double& changed, double& largest) const
  {
    for (int d = 0; d < D; ++d)
    {
      const double change = fraction * (contacts.wanted(c, d) - contacts.impulse(c, d));
      changed = std::fmax(changed, std::fabs(change));
      largest = std::fmax(largest, std::fabs(contacts.wanted(c, d)));
      if (change == 0.0)
        continue;
      contacts.impulse(c, d) = fraction == 1.0 ? contacts.wanted(c, d) : contacts.impulse(c, d) + change;
      for (int e = 0; e < contacts.parts(c); ++e)
      {
        const int row = contacts.partRow(c, e);
        const double mass = nodes.sums(row, Nodes<D>::massAt), part = contacts.part(c, e) * change;
        nodes.motion(row, d) += part / mass;
        nodes.motion(row, Nodes<D>::accelerationAt + d) += part / (mass * dt);
      }
    }
  }
};

/// Finds and applies the impulse of one contact after the other.
template <int D>
struct SweepImpulses
{
  FindImpulses<D> find;
  ApplyImpulses<D> put;

  KOKKOS_INLINE_FUNCTION void operator()(const int c, double& changed, double& largest) const
  {
    find(c);
    put.apply(c, changed, largest);
  }
};

template <int D>
Vector<D> sumOfImpulses(const ToolContacts<D>& contacts)
{
  return sumContacts(contacts).impulse;
}

/// Finds and applies the impulses of all contacts once. Of a tool with a mass all are found together, and of
/// those that have nodes in common half of the change is applied: as each cell has two such contacts at most,
/// this converges (Jacobi's method with relaxation).
template <int D>
Changes sweepContacts(const Nodes<D>& nodes, Tool<D>& tool, ToolContacts<D>& contacts, bool together,
                      double dt)
{
  Changes changes;
  if (!tool.hasMass())
  {
    inOrder("rhegma::sweepImpulsesOfTool", contacts.count,
            SweepImpulses<D>{{{nodes, contacts, tool.law(), tool.velocity()}}, {nodes, contacts, dt, 1.0}},
            changes.changed, changes.largest);
    return changes;
  }
  // Impulses of an earlier call have changed its velocity already.
  const Vector<D> alone =
      tool.velocity().ofCentre + (1.0 / tool.mass().mass) * tool.freePart(sumOfImpulses(contacts));
  contacts.cut = findImpulsesOfMass(nodes, tool, contacts, alone);
  const ApplyImpulses<D> put{nodes, contacts, dt, together ? 0.5 : 1.0};
  inOrder(
      "rhegma::applyImpulsesOfTool", contacts.count,
      KOKKOS_LAMBDA(const int c, double& changed, double& largest) { put.apply(c, changed, largest); },
      changes.changed, changes.largest);
  tool.setVelocity(alone - (1.0 / tool.mass().mass) * tool.freePart(sumOfImpulses(contacts)));
  return changes;
}

} // namespace

template <int D>
double exchangeImpulses(const State<D>& state, Tool<D>& tool, ToolContacts<D>& contacts)
{
  contacts.cut = 0;
  if (contacts.count == 0 || !(state.clock.dt > 0.0))
    return 0.0;
  const Nodes<D> nodes = state.mesh.nodes;
  const bool together = haveCommonNodes(contacts);
  double first = 0.0;
  for (int sweep = 0; sweep < (together ? mostSweepsOfContacts : 1); ++sweep)
  {
    const Changes changes = sweepContacts(nodes, tool, contacts, together, state.clock.dt);
    const double change = changes.largest > 0.0 ? changes.changed / changes.largest : 0.0;
    first = sweep == 0 ? change : first;
    if (!(change > settledSweep))
      break;
  }
  return first;
}

template double exchangeImpulses(const State<2>&, Tool<2>&, ToolContacts<2>&);
template double exchangeImpulses(const State<3>&, Tool<3>&, ToolContacts<3>&);

} // namespace Rhegma::rigid_tools
