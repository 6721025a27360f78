#include "rigid_tools/ToolImpulses.hpp"

#include "base/SmallLoops.hpp"

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

/// Sums of the impulses of a tool with a mass and of their derivatives by its velocity.
template <int D>
struct SumImpulses
{
  using value_type = double[];
  using size_type = int;

  static constexpr int size = D + D * D;
  int value_count = size;
  ImpulseOf<D> of;

  KOKKOS_INLINE_FUNCTION void operator()(const int c, double* sum) const
  {
    const ContactImpulse<D> contact = of(c);
    if (!(contact.pressing > 0.0))
      return;
    const double mass = of.nodes.sums(of.contacts.row(c), Nodes<D>::massAt);
    const Vector<D> n = vectorAt<D>(of.contacts.normal, c);
    for (int i = 0; i < D; ++i)
    {
      sum[i] += contact.impulse[i];
      for (int j = 0; j < D; ++j)
      {
        const double both = i == j && of.contacts.held(c, i) == 0 ? 1.0 : 0.0;
        // Of a face that slides, friction follows the pressure.
        const double along = contact.impulse[i] / contact.pressing * n[j];
        sum[D + D * i + j] += mass * (contact.sticks ? both : along);
      }
    }
  }
};

/// Solves a small system; axes that do not move are left out.
template <int D>
Vector<D> solve(double (&matrix)[D][D], Vector<D> right)
{
  for (int i = 0; i < D; ++i)
    for (int k = i + 1; k < D; ++k)
    {
      const double factor = matrix[k][i] / matrix[i][i];
      for (int j = i; j < D; ++j)
        matrix[k][j] -= factor * matrix[i][j];
      right[k] -= factor * right[i];
    }
  for (int i = D - 1; i >= 0; --i)
  {
    for (int j = i + 1; j < D; ++j)
      right[i] -= matrix[i][j] * right[j];
    right[i] /= matrix[i][i];
  }
  return right;
}

/// Finds the velocity of a tool with a mass by Newton's method: its momentum, without contact, falls by the
/// impulses at this velocity. They are piecewise linear in it, so that few iterations are exact.
/// \param alone its velocity if it had no contact [m/s]
template <int D>
Vector<D> velocityWithContact(const Tool<D>& tool, ImpulseOf<D> of, const Vector<D>& alone)
{
  constexpr int most = 50;
  constexpr double settled = 1e-14;
  Vector<D> velocity = tool.velocity().ofCentre;
  for (int k = 0; k < most; ++k)
  {
    of.tool.ofCentre = velocity;
    SumImpulses<D> add;
    add.of = of;
    double sum[SumImpulses<D>::size] = {};
    parallelSumSmall("rhegma::sumImpulsesOfTool", 0, of.contacts.count, add, sum);
    double matrix[D][D];
    Vector<D> right;
    for (int i = 0; i < D; ++i)
    {
      const bool moves = tool.moves(i);
      right[i] = moves ? tool.mass().mass * (alone[i] - velocity[i]) - sum[i] : 0.0;
      for (int j = 0; j < D; ++j)
        matrix[i][j] =
            (i == j ? tool.mass().mass : 0.0) + (moves && tool.moves(j) ? sum[D + D * i + j] : 0.0);
    }
    const Vector<D> change = solve<D>(matrix, right);
    velocity = velocity + change;
    if (!(norm(change) > settled * (norm(velocity) + norm(alone))))
      break;
  }
  return velocity;
}

/// Applies the impulses. \return the largest change of an impulse, and the largest impulse
template <int D>
struct ApplyImpulses
{
  ImpulseOf<D> of;
  double dt;

  KOKKOS_INLINE_FUNCTION void operator()(const int c, double& changed, double& largest) const
  {
    const ContactImpulse<D> contact = of(c);
    const int row = of.contacts.row(c);
    const double mass = of.nodes.sums(row, Nodes<D>::massAt);
    of.contacts.sticks(c) = contact.sticks ? 1 : 0;
    for (int d = 0; d < D; ++d)
    {
      const double change = contact.impulse[d] - of.contacts.impulse(c, d);
      changed = std::fmax(changed, std::fabs(change));
      largest = std::fmax(largest, std::fabs(contact.impulse[d]));
      if (change == 0.0)
        continue;
      of.contacts.impulse(c, d) = contact.impulse[d];
      of.nodes.motion(row, d) += change / mass;
      of.nodes.motion(row, Nodes<D>::accelerationAt + d) += change / (mass * dt);
    }
  }
};

template <int D>
Vector<D> sumOfImpulses(const ToolContacts<D>& contacts)
{
  return sumContacts(contacts).impulse;
}

/// Joins the projection of a contact with the velocity of the tool.
template <int D>
struct JoinProjection
{
  Nodes<D> nodes;
  ToolContacts<D> contacts;
  RigidVelocity<D> now, mean; ///< of the tool
  double dt;

  KOKKOS_INLINE_FUNCTION void operator()(const int c) const
  {
    const Vector<D> impulse = vectorAt<D>(contacts.impulse, c), n = vectorAt<D>(contacts.normal, c),
                    arm = vectorAt<D>(contacts.arm, c);
    contacts.taken(c, 0) = contacts.taken(c, 1) = contacts.work(c) = 0.0;
    if (!(dot(impulse, impulse) > 0.0))
      return;
    const int row = contacts.row(c);
    const double mass = nodes.sums(row, Nodes<D>::massAt);
    Vector<D> projected, force, before;
    for (int d = 0; d < D; ++d)
    {
      projected[d] = nodes.projection(row, d);
      before[d] = nodes.sums(row, Nodes<D>::momentumAt + d) / mass;
      force[d] = nodes.sums(row, Nodes<D>::forceAt + d);
    }
    const Vector<D> surface = mean.at(arm), relative = 0.5 * (before + projected) - surface;
    const double all = -dot(impulse, relative), across = -dot(impulse, n) * dot(relative, n);
    Vector<D> toTool = now.at(arm) - projected;
    for (int d = 0; d < D; ++d)
      toTool[d] = contacts.held(c, d) != 0 ? 0.0 : toTool[d];
    const Vector<D> normal = dot(toTool, n) * n;
    const Vector<D> face = contacts.sticks(c) != 0 ? toTool - normal : Vector<D>{};
    for (int d = 0; d < D; ++d)
      nodes.projection(row, d) += normal[d] + face[d];
    const double byFace = dt * dot(force, face);
    contacts.taken(c, 0) = all + dt * dot(force, normal) + byFace;
    contacts.taken(c, 1) = all - across + byFace;
    contacts.work(c) = dot(impulse, surface);
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
double exchangeImpulses(const State<D>& state, Tool<D>& tool, const ToolContacts<D>& contacts)
{
  if (contacts.count == 0 || !(state.clock.dt > 0.0))
    return 0.0;
  ImpulseOf<D> of{state.mesh.nodes, contacts, tool.law(), tool.velocity()};
  Vector<D> alone = tool.velocity().ofCentre;
  if (tool.hasMass())
  {
    // Impulses of an earlier call have changed its velocity already.
    alone = alone + (1.0 / tool.mass().mass) * tool.freePart(sumOfImpulses(contacts));
    of.tool.ofCentre = velocityWithContact(tool, of, alone);
  }
  double changed = 0.0, largest = 0.0;
  parallelSumSmall("rhegma::applyImpulsesOfTool", 0, contacts.count, ApplyImpulses<D>{of, state.clock.dt},
                   Kokkos::Max<double>(changed), Kokkos::Max<double>(largest));
  if (tool.hasMass())
    tool.setVelocity(alone - (1.0 / tool.mass().mass) * tool.freePart(sumOfImpulses(contacts)));
  return largest > 0.0 ? changed / largest : 0.0;
}

template <int D>
void joinProjection(const State<D>& state, const Tool<D>& tool, const ToolContacts<D>& contacts)
{
  const JoinProjection<D> join{state.mesh.nodes, contacts, tool.velocity(), tool.meanVelocity(),
                               state.clock.dt};
  parallelForSmall("rhegma::joinProjectionAtTool", contacts.count, join);
}

template <int D>
ToolSums<D> sumContacts(const ToolContacts<D>& contacts)
{
  ToolSums<D> sums;
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

template double exchangeImpulses(const State<2>&, Tool<2>&, const ToolContacts<2>&);
template double exchangeImpulses(const State<3>&, Tool<3>&, const ToolContacts<3>&);
template void joinProjection(const State<2>&, const Tool<2>&, const ToolContacts<2>&);
template void joinProjection(const State<3>&, const Tool<3>&, const ToolContacts<3>&);
template ToolSums<2> sumContacts(const ToolContacts<2>&);
template ToolSums<3> sumContacts(const ToolContacts<3>&);

} // namespace Rhegma::rigid_tools
