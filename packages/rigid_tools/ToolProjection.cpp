/// The energy and work of the impulses of tools, and the velocity that strains the particles at them.

#include "base/SmallLoops.hpp"
#include "rigid_tools/ContactParts.hpp"
#include "rigid_tools/ContactsInOrder.hpp"
#include "rigid_tools/ToolImpulses.hpp"

namespace Rhegma::rigid_tools
{

namespace
{

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

} // namespace

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

template void countImpulses(const State<2>&, const Tool<2>&, const ToolContacts<2>&);
template double joinProjection(const State<2>&, const Tool<2>&, const ToolContacts<2>&);
template void countImpulses(const State<3>&, const Tool<3>&, const ToolContacts<3>&);
template double joinProjection(const State<3>&, const Tool<3>&, const ToolContacts<3>&);
template ToolSums<2> sumContacts(const ToolContacts<2>&);
template ToolSums<3> sumContacts(const ToolContacts<3>&);

} // namespace Rhegma::rigid_tools
