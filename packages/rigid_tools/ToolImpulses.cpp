#include "rigid_tools/ToolImpulses.hpp"

#include "base/SmallLoops.hpp"
#include "rigid_tools/ContactParts.hpp"
#include "rigid_tools/FreeVelocity.hpp"

#include <algorithm>
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

/// Runs body(c, ...) for all contacts, one after the other.
template <class Body, class... Sums>
void inOrder(const char* label, int count, const Body& body, Sums&... sums)
{
  Kokkos::parallel_reduce(
      label, Kokkos::RangePolicy<ExecSpace>(0, 1),
      KOKKOS_LAMBDA(const int, Sums&... sum) {
        for (int c = 0; c < count; ++c)
          body(c, sum...);
      },
      Kokkos::Max<Sums>(sums)...);
}

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
    const Vector<D> velocity = velocityAt(contacts, c,
                                          [&](int row, int d) // the mean over the step
                                          {
                                            return 0.5 * (nodes.sums(row, Nodes<D>::momentumAt + d) /
                                                              nodes.sums(row, Nodes<D>::massAt) +
                                                          nodes.projection(row, d));
                                          });
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
    const Vector<D> surface = now.at(vectorAt<D>(contacts.arm, c)),
                    velocity = velocityAt(contacts, c, nodes.projection);
    Vector<D> toTool, force{}; // the force: of the nodes, as it accelerates the point of the contact
    for (int d = 0; d < D; ++d)
      toTool[d] = contacts.held(c, d) != 0 ? 0.0 : surface[d] - velocity[d];
    const Vector<D> normal = dot(toTool, n) * n;
    const Vector<D> face = contacts.sticks(c) != 0 ? toTool - normal : Vector<D>{};
    for (int e = 0; e < contacts.parts(c); ++e)
    {
      const int row = contacts.partRow(c, e);
      // One of nodes in the same proportion as an impulse would change them.
      const double part = contacts.part(c, e) * contacts.mass(c) / nodes.sums(row, Nodes<D>::massAt);
      for (int d = 0; d < D; ++d)
      {
        force[d] += part * nodes.sums(row, Nodes<D>::forceAt + d);
        nodes.projection(row, d) += part * (normal[d] + face[d]);
      }
    }
    for (int d = 0; d < D; ++d)
      changed = std::fmax(changed, std::fabs(normal[d] + face[d]));
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

/// Sweeps over the contacts of a tool that have nodes in common end when no impulse changes by more than this
/// fraction of the largest one, or after so many: what is left is a difference of velocities along the face.
constexpr double settledSweep = 1e-7;
constexpr int mostSweepsOfContacts = 60;

/// Whether contacts have nodes in common.
template <int D>
bool haveCommonNodes(const ToolContacts<D>& contacts)
{
  const auto rows = onHost(contacts.partRow);
  const auto parts = onHost(contacts.parts);
  std::vector<int> all;
  for (int c = 0; c < contacts.count; ++c)
    for (int e = 0; e < parts(c); ++e)
      all.push_back(rows(c, e));
  std::sort(all.begin(), all.end());
  return std::adjacent_find(all.begin(), all.end()) != all.end();
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
  const int sweeps = haveCommonNodes(contacts) ? mostSweepsOfContacts : 1;
  double first = 0.0;
  for (int sweep = 0; sweep < sweeps; ++sweep)
  {
    double changed = 0.0;
    inOrder("rhegma::joinProjectionAtTool", contacts.count,
            JoinProjection<D>{state.mesh.nodes, contacts, tool.velocity(), state.clock.dt}, changed);
    changed = std::fmax(changed, 0.0);
    first = sweep == 0 ? changed : first;
    if (!(changed > settledSweep * first))
      break;
  }
  return first;
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
