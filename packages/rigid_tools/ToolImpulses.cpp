#include "rigid_tools/ToolImpulses.hpp"

#include "base/SmallLoops.hpp"
#include "rigid_tools/FreeVelocity.hpp"

#include <vector>

namespace Rhegma::rigid_tools
{

namespace
{

template <int D>
KOKKOS_INLINE_FUNCTION Vector<D> vectorAt(const View<double* [D]>& vectors, int k)
{
  Vector<D> v;
  for (int d = 0; d < D; ++d)
    v[d] = vectors(k, d);
  return v;
}

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
    const int row = contacts.row(c);
    const double mass = nodes.sums(row, Nodes<D>::massAt);
    const Vector<D> n = vectorAt<D>(contacts.normal, c);
    if (!(mass > 0.0) || !(dot(n, n) > 0.0))
      return {};
    const Vector<D> surface = tool.at(vectorAt<D>(contacts.arm, c));
    Vector<D> alike;
    for (int d = 0; d < D; ++d)
      alike[d] = contacts.held(c, d) != 0
                     ? 0.0
                     : contacts.impulse(c, d) + mass * (surface[d] - nodes.motion(row, d));
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
        const int row = at.row(c);
        const double mass = nodes.sums(row, Nodes<D>::massAt);
        packed(c, 2 * D) = mass;
        for (int d = 0; d < D; ++d)
        {
          packed(c, d) = at.normal(c, d);
          packed(c, D + d) = mass > 0.0 ? nodes.motion(row, d) - at.impulse(c, d) / mass : 0.0;
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

/// Applies the impulses that are wanted. \return the largest change of an impulse, and the largest impulse
template <int D>
struct ApplyImpulses
{
  Nodes<D> nodes;
  ToolContacts<D> contacts;
  double dt;

  KOKKOS_INLINE_FUNCTION void operator()(const int c, double& changed, double& largest) const
  {
    const int row = contacts.row(c);
    const double mass = nodes.sums(row, Nodes<D>::massAt);
    for (int d = 0; d < D; ++d)
    {
      const double change = contacts.wanted(c, d) - contacts.impulse(c, d);
      changed = std::fmax(changed, std::fabs(change));
      largest = std::fmax(largest, std::fabs(contacts.wanted(c, d)));
      if (change == 0.0)
        continue;
      contacts.impulse(c, d) = contacts.wanted(c, d);
      nodes.motion(row, d) += change / mass;
      nodes.motion(row, Nodes<D>::accelerationAt + d) += change / (mass * dt);
    }
  }
};

template <int D>
Vector<D> sumOfImpulses(const ToolContacts<D>& contacts)
{
  return sumContacts(contacts).impulse;
}

/// Finds the energy that the impulse of a contact takes from the particles' motion, and its work.
template <int D>
struct CountImpulse
{
  Nodes<D> nodes;
  ToolContacts<D> contacts;
  RigidVelocity<D> mean; ///< of the tool

  KOKKOS_INLINE_FUNCTION void operator()(const int c) const
  {
    const Vector<D> impulse = vectorAt<D>(contacts.impulse, c), n = vectorAt<D>(contacts.normal, c);
    contacts.taken(c, 0) = contacts.taken(c, 1) = contacts.work(c) = 0.0;
    if (!(dot(impulse, impulse) > 0.0))
      return;
    const int row = contacts.row(c);
    const double mass = nodes.sums(row, Nodes<D>::massAt);
    Vector<D> velocity; // the mean over the step
    for (int d = 0; d < D; ++d)
      velocity[d] = 0.5 * (nodes.sums(row, Nodes<D>::momentumAt + d) / mass + nodes.projection(row, d));
    const Vector<D> surface = mean.at(vectorAt<D>(contacts.arm, c)), relative = velocity - surface;
    const double all = -dot(impulse, relative), across = -dot(impulse, n) * dot(relative, n);
    contacts.taken(c, 0) = all;
    contacts.taken(c, 1) = all - across;
    contacts.work(c) = dot(impulse, surface);
  }
};

/// Joins the projection of a contact with the velocity of the tool. Finds the largest change.
template <int D>
struct JoinProjection
{
  Nodes<D> nodes;
  ToolContacts<D> contacts;
  RigidVelocity<D> now; ///< of the tool
  double dt;

  KOKKOS_INLINE_FUNCTION void operator()(const int c, double& changed) const
  {
    const Vector<D> impulse = vectorAt<D>(contacts.impulse, c), n = vectorAt<D>(contacts.normal, c);
    if (!(dot(impulse, impulse) > 0.0))
      return;
    const int row = contacts.row(c);
    const Vector<D> surface = now.at(vectorAt<D>(contacts.arm, c));
    Vector<D> toTool, force;
    for (int d = 0; d < D; ++d)
    {
      toTool[d] = contacts.held(c, d) != 0 ? 0.0 : surface[d] - nodes.projection(row, d);
      force[d] = nodes.sums(row, Nodes<D>::forceAt + d);
    }
    const Vector<D> normal = dot(toTool, n) * n;
    const Vector<D> face = contacts.sticks(c) != 0 ? toTool - normal : Vector<D>{};
    for (int d = 0; d < D; ++d)
    {
      nodes.projection(row, d) += normal[d] + face[d];
      changed = std::fmax(changed, std::fabs(normal[d] + face[d]));
    }
    const double byFace = dt * dot(force, face);
    contacts.taken(c, 0) += dt * dot(force, normal) + byFace;
    contacts.taken(c, 1) += byFace;
  }
};

/// Sums over contacts: impulse, energy taken, the part of it along the faces, work, number that press.
template <int D>
struct AddContacts
{
  using value_type = double[];
  using size_type = int;

  static constexpr int size = D + 4;
  int value_count = size;
  ToolContacts<D> contacts;

  KOKKOS_INLINE_FUNCTION bool presses(int c) const
  {
    bool any = false;
    for (int d = 0; d < D; ++d)
      any = any || contacts.impulse(c, d) != 0.0;
    return any;
  }

  KOKKOS_INLINE_FUNCTION void operator()(const int c, double* sum) const
  {
    if (!presses(c))
      return;
    for (int d = 0; d < D; ++d)
      sum[d] += contacts.impulse(c, d);
    sum[D] += contacts.taken(c, 0);
    sum[D + 1] += contacts.taken(c, 1);
    sum[D + 2] += contacts.work(c);
    sum[D + 3] += 1.0;
  }
};

/// The largest overlap of contacts that press.
template <int D>
struct LargestOverlap
{
  AddContacts<D> add;

  KOKKOS_INLINE_FUNCTION void operator()(const int c, double& most) const
  {
    if (add.presses(c) && -add.contacts.gap(c) > most)
      most = -add.contacts.gap(c);
  }
};

} // namespace

template <int D>
double exchangeImpulses(const State<D>& state, Tool<D>& tool, ToolContacts<D>& contacts)
{
  contacts.cut = 0;
  if (contacts.count == 0 || !(state.clock.dt > 0.0))
    return 0.0;
  const Nodes<D> nodes = state.mesh.nodes;
  Vector<D> alone = tool.velocity().ofCentre;
  if (tool.hasMass())
  {
    // Impulses of an earlier call have changed its velocity already.
    alone = alone + (1.0 / tool.mass().mass) * tool.freePart(sumOfImpulses(contacts));
    contacts.cut = findImpulsesOfMass(nodes, tool, contacts, alone);
  }
  else
    parallelForSmall("rhegma::findImpulsesOfTool", contacts.count,
                     FindImpulses<D>{{nodes, contacts, tool.law(), tool.velocity()}});
  double changed = 0.0, largest = 0.0;
  parallelSumSmall("rhegma::applyImpulsesOfTool", 0, contacts.count,
                   ApplyImpulses<D>{nodes, contacts, state.clock.dt}, Kokkos::Max<double>(changed),
                   Kokkos::Max<double>(largest));
  if (tool.hasMass())
    tool.setVelocity(alone - (1.0 / tool.mass().mass) * tool.freePart(sumOfImpulses(contacts)));
  return largest > 0.0 ? changed / largest : 0.0;
}

template <int D>
void countImpulses(const State<D>& state, const Tool<D>& tool, const ToolContacts<D>& contacts)
{
  parallelForSmall("rhegma::countImpulsesOfTool", contacts.count,
                   CountImpulse<D>{state.mesh.nodes, contacts, tool.meanVelocity()});
}

template <int D>
double joinProjection(const State<D>& state, const Tool<D>& tool, const ToolContacts<D>& contacts)
{
  if (contacts.count == 0)
    return 0.0;
  double changed = 0.0;
  parallelSumSmall("rhegma::joinProjectionAtTool", 0, contacts.count,
                   JoinProjection<D>{state.mesh.nodes, contacts, tool.velocity(), state.clock.dt},
                   Kokkos::Max<double>(changed));
  return std::fmax(changed, 0.0);
}

template <int D>
ToolSums<D> sumContacts(const ToolContacts<D>& contacts)
{
  ToolSums<D> sums;
  sums.cut = contacts.count > 0 ? contacts.cut : 0;
  if (contacts.count == 0)
    return sums;
  AddContacts<D> add;
  add.contacts = contacts;
  double sum[AddContacts<D>::size] = {};
  parallelSumSmall("rhegma::sumContactsOfTool", 0, contacts.count, add, sum);
  for (int d = 0; d < D; ++d)
    sums.impulse[d] = sum[d];
  sums.dissipated = sum[D];
  sums.friction = sum[D + 1];
  sums.work = sum[D + 2];
  sums.closed = static_cast<int>(sum[D + 3]);
  parallelSumSmall("rhegma::overlapAtTool", 0, contacts.count, LargestOverlap<D>{add},
                   Kokkos::Max<double>(sums.overlap));
  sums.overlap = sums.closed > 0 ? sums.overlap : 0.0;
  return sums;
}

template double exchangeImpulses(const State<2>&, Tool<2>&, ToolContacts<2>&);
template double exchangeImpulses(const State<3>&, Tool<3>&, ToolContacts<3>&);
template void countImpulses(const State<2>&, const Tool<2>&, const ToolContacts<2>&);
template double joinProjection(const State<2>&, const Tool<2>&, const ToolContacts<2>&);
template void countImpulses(const State<3>&, const Tool<3>&, const ToolContacts<3>&);
template double joinProjection(const State<3>&, const Tool<3>&, const ToolContacts<3>&);
template ToolSums<2> sumContacts(const ToolContacts<2>&);
template ToolSums<3> sumContacts(const ToolContacts<3>&);

} // namespace Rhegma::rigid_tools
