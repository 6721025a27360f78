/// Impulses between the fields of shared nodes.

#include "base/SmallLoops.hpp"
#include "body_contact/NodalContact.hpp"
#include "body_contact/PressedPairs.hpp"
#include "boundary/HeldMarks.hpp"
#include "transfer/PressedNodes.hpp"

namespace Rhegma::body_contact
{

namespace
{

/// A field with less mass than this fraction of the other one at its node is left out: rounding decides
/// whether its group touches the node at all.
constexpr double lightField = 1e-12;

/// Sweeps over the pairs of a node with more than two fields end when no impulse changes by more than this
/// fraction of the largest one.
constexpr double settledChange = 1e-9;

/// Most sweeps: a field of mass m between two of mass M settles by (M / (M + m))^2 a sweep, so that 2 % are
/// left where m is a thousandth of M.
constexpr int mostSweeps = 2000;

/// Exchanges the impulses of the pairs of a node, one pair after the other.
template <int D>
struct ExchangeImpulses
{
  Nodes<D> nodes;
  SharedNodes<D> shared;
  NodalPairs<D> pairs;
  PairLaws laws;
  View<char* [D]> held;
  PressedPairs pressed;
  double reach; ///< gap up to which pairs that pressed in the last step still do [m]
  double dt;

  KOKKOS_INLINE_FUNCTION void operator()(const int s) const
  {
    const int begin = pairs.first(s), end = pairs.first(s + 1);
    const int rounds = end - begin > 1 ? mostSweeps : 1;
    for (int k = 0; k < rounds; ++k)
    {
      double changed = 0.0, largest = 0.0;
      for (int q = begin; q < end; ++q)
        if (const bool joined = pairs.springs.join(q); joined || touches(q, begin, end))
        {
          changed = std::fmax(changed, joined ? pull(s, q) : press(s, q));
          for (int d = 0; d < D; ++d)
            largest = std::fmax(largest, std::fabs(pairs.impulse(q, d)));
        }
      if (!(changed > settledChange * largest))
        return;
    }
  }

  /// Whether two fields touch, or still do. Else faces between rows of nodes are soft by what they approach
  /// until their domains meet again in each step. What is remembered is the pair of groups: next to a crack
  /// one of its two fields would keep the other in contact, which made blocks with a crack in their base
  /// stick. \param begin, end pairs at the node
  KOKKOS_INLINE_FUNCTION bool touches(int q, int begin, int end) const
  {
    bool alone = true;
    for (int other = begin; other < end; ++other)
      alone = alone && (other == q || pairs.group(other, 0) != pairs.group(q, 0) ||
                        pairs.group(other, 1) != pairs.group(q, 1));
    const bool still = alone && pressed(pairs.node(q), pairs.group(q, 0), pairs.group(q, 1));
    return pairs.gap(q) <= (still ? reach : 0.0);
  }

  /// Brings the impulse of a pair to the one with which its law holds, the others as they are. \return the
  /// largest change of its components
  KOKKOS_INLINE_FUNCTION double press(int s, int q) const
  {
    const int a = pairs.row(q, 0), b = pairs.row(q, 1);
    const double massA = nodes.sums(a, Nodes<D>::massAt), massB = nodes.sums(b, Nodes<D>::massAt);
    if (!(massA > lightField * massB) || !(massB > lightField * massA))
      return 0.0;
    const double reduced = massA * massB / (massA + massB);
    Vector<D> n, sticking; // free axes of the normal, and the impulse after which the two move alike
    for (int d = 0; d < D; ++d)
    {
      n[d] = held(s, d) != 0 ? 0.0 : pairs.normal(q, d);
      const double relative = held(s, d) != 0 ? 0.0 : nodes.motion(b, d) - nodes.motion(a, d);
      sticking[d] = pairs.impulse(q, d) - reduced * relative;
    }
    const double length = norm(n);
    if (!(length > 1e-6))
      return 0.0;
    n = (1.0 / length) * n;
    const ContactImpulse<D> contact = contactImpulse(laws(pairs.group(q, 0), pairs.group(q, 1)), n, sticking);
    const Vector<D> impulse = contact.impulse;
    if (contact.pressing > 0.0)
    {
      pairs.loses(q, 0) = 1.0;
      pairs.loses(q, 1) = contact.sticks ? 1.0 : 0.0;
    }
    for (int d = 0; d < D; ++d)
    {
      pairs.normal(q, d) = n[d];
      pairs.aim(q, d) = 0.0;
    }
    return exchange(q, impulse);
  }

  /// Brings the impulse of a pair that springs join to theirs. With the mass m and the stiffness k of one
  /// direction, xi = k dt^2 / m, the force is that of the jump at the start of the step, and of theta times
  /// its change: explicit for soft springs (theta = 0 keeps their energy), and implicit for stiff ones (theta
  /// = 1 lets the jump decay instead of swinging from step to step). theta = xi / (1 + xi) is stable for each
  /// xi, since theta > 1/2 - 2 / xi. \return as press
  KOKKOS_INLINE_FUNCTION double pull(int s, int q) const
  {
    const int a = pairs.row(q, 0), b = pairs.row(q, 1);
    const double massA = nodes.sums(a, Nodes<D>::massAt), massB = nodes.sums(b, Nodes<D>::massAt);
    if (!(massA > lightField * massB) || !(massB > lightField * massA))
      return 0.0;
    const double reduced = massA * massB / (massA + massB);
    Vector<D> n, free, force; // free: relative velocity without the springs
    for (int d = 0; d < D; ++d)
    {
      const bool axisHeld = held(s, d) != 0;
      n[d] = axisHeld ? 0.0 : pairs.springs.normal(q, d);
      free[d] = axisHeld ? 0.0 : nodes.motion(b, d) - nodes.motion(a, d) - pairs.impulse(q, d) / reduced;
      force[d] = axisHeld ? 0.0 : pairs.springs.force(q, d);
    }
    const double length = norm(n);
    n = length > 0.0 ? (1.0 / length) * n : n;
    Vector<D> aim{}, rest = free, pulling = force;
    for (int part = 0; part < 2; ++part)
    {
      const double xi = dt * dt * stiffnessOf(s, q, n, part) / reduced, implicit = xi * xi / (1.0 + xi);
      const Vector<D> v = part == 0 ? dot(free, n) * n : rest, f = part == 0 ? dot(force, n) * n : pulling;
      rest = rest - v;
      pulling = pulling - f;
      aim = aim + (1.0 / (1.0 + implicit)) * (v - (dt / reduced) * f);
      pairs.loses(q, part) = implicit / (1.0 + implicit);
    }
    for (int d = 0; d < D; ++d)
    {
      pairs.normal(q, d) = n[d];
      pairs.aim(q, d) = aim[d];
    }
    pairs.gap(q) = 0.0;
    return exchange(q, reduced * (aim - free));
  }

  /// Stiffness of a node's springs along its normal (part 0), and the largest along the faces, on free axes;
  /// more where normals differ, by what couples the two [N/m]. \param n zero where normals are held or cancel
  KOKKOS_INLINE_FUNCTION double stiffnessOf(int s, int q, const Vector<D>& n, int part) const
  {
    double free[D][D] = {};
    Vector<D> product{};
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
      {
        free[i][j] = held(s, i) != 0 || held(s, j) != 0 ? 0.0 : pairs.springs.stiffness(q, i, j);
        product[i] += free[i][j] * n[j];
      }
    const double across = dot(n, product), coupling = norm(product - across * n);
    if (part == 0)
      return coupling + across;
    // Along the faces there are two stiffnesses at most: trace and squares are their sum and the sum of their
    // squares. Where normals cancel there may be three, of which the root of the squares is a bound.
    double trace = 0.0, squares = 0.0;
    bool two = D == 2 || dot(n, n) > 0.0;
    for (int i = 0; i < D; ++i)
    {
      two = two || held(s, i) != 0;
      for (int j = 0; j < D; ++j)
      {
        const double along = free[i][j] - n[i] * product[j] - product[i] * n[j] + across * n[i] * n[j];
        trace += i == j ? along : 0.0;
        squares += along * along;
      }
    }
    const double apart = std::fmax(0.0, 2.0 * squares - trace * trace); // square of the difference of the two
    return coupling + (two ? 0.5 * (trace + std::sqrt(apart)) : std::sqrt(squares));
  }

  /// Changes the impulse of a pair, and the motion of its two fields. \return the largest change
  KOKKOS_INLINE_FUNCTION double exchange(int q, const Vector<D>& impulse) const
  {
    const int a = pairs.row(q, 0), b = pairs.row(q, 1);
    const double massA = nodes.sums(a, Nodes<D>::massAt), massB = nodes.sums(b, Nodes<D>::massAt);
    double changed = 0.0;
    for (int d = 0; d < D; ++d)
    {
      const double change = impulse[d] - pairs.impulse(q, d);
      changed = std::fmax(changed, std::fabs(change));
      pairs.impulse(q, d) = impulse[d];
      push(a, d, -change, massA);
      push(b, d, change, massB);
    }
    return changed;
  }

  KOKKOS_INLINE_FUNCTION void push(int row, int axis, double impulse, double mass) const
  {
    nodes.motion(row, axis) += impulse / mass;
    nodes.motion(row, Nodes<D>::accelerationAt + axis) += impulse / (mass * dt);
  }
};

/// Joins the projection of the pairs of a node, one pair after the other.
template <int D>
struct JoinProjection
{
  Nodes<D> nodes;
  NodalPairs<D> pairs;
  double dt;

  KOKKOS_INLINE_FUNCTION void operator()(const int s) const
  {
    const int begin = pairs.first(s), end = pairs.first(s + 1);
    for (int q = begin; q < end; ++q)
      if (presses(q))
        countImpulse(q);
    const int rounds = end - begin > 1 ? mostSweeps : 1;
    double first = 0.0; // the largest change of the first sweep
    for (int k = 0; k < rounds; ++k)
    {
      double changed = 0.0;
      for (int q = begin; q < end; ++q)
        if (presses(q) && (k == 0 || !pairs.springs.join(q)))
          changed = std::fmax(changed, join(q));
      first = k == 0 ? changed : first;
      if (!(changed > settledChange * first))
        return;
    }
  }

  KOKKOS_INLINE_FUNCTION bool presses(int q) const
  {
    bool any = false;
    for (int d = 0; d < D; ++d)
      any = any || pairs.impulse(q, d) != 0.0;
    return any;
  }

  /// A vector along the normal, and along the faces.
  KOKKOS_INLINE_FUNCTION double partAlongNormal(int q, const Vector<D>& vector) const
  {
    double sum = 0.0;
    for (int d = 0; d < D; ++d)
      sum += vector[d] * pairs.normal(q, d);
    return sum;
  }

  /// Energy that the impulse takes from the particles' motion.
  KOKKOS_INLINE_FUNCTION void countImpulse(int q) const
  {
    Vector<D> velocity{}, impulse; // relative, the mean over the step
    for (int d = 0; d < D; ++d)
    {
      for (int k = 0; k < 2; ++k)
      {
        const int n = pairs.row(q, k);
        const double mean = 0.5 * (nodes.sums(n, Nodes<D>::momentumAt + d) / nodes.sums(n, Nodes<D>::massAt) +
                                   nodes.projection(n, d));
        velocity[d] += k == 0 ? -mean : mean;
      }
      impulse[d] = pairs.impulse(q, d);
    }
    const double all = -dot(impulse, velocity);
    pairs.taken(q, 0) = all;
    pairs.taken(q, 1) =
        pairs.springs.join(q) ? 0.0 : all + partAlongNormal(q, impulse) * partAlongNormal(q, velocity);
  }

  /// \return the largest change of the relative velocity
  KOKKOS_INLINE_FUNCTION double join(int q) const
  {
    const int a = pairs.row(q, 0), b = pairs.row(q, 1);
    const double massA = nodes.sums(a, Nodes<D>::massAt), massB = nodes.sums(b, Nodes<D>::massAt);
    const double reduced = massA * massB / (massA + massB);
    Vector<D> relative;
    for (int d = 0; d < D; ++d)
      relative[d] = nodes.projection(b, d) - nodes.projection(a, d) - pairs.aim(q, d);
    const double across = partAlongNormal(q, relative);
    double work[2] = {0.0, 0.0}; // of the other forces by the change, along the normal and along the faces
    double changed = 0.0;
    for (int d = 0; d < D; ++d)
    {
      const double component = across * pairs.normal(q, d), normal = pairs.loses(q, 0) * component;
      const double face = pairs.loses(q, 1) > 0.0 ? pairs.loses(q, 1) * (relative[d] - component) : 0.0;
      const double force =
          nodes.sums(a, Nodes<D>::forceAt + d) / massA - nodes.sums(b, Nodes<D>::forceAt + d) / massB;
      work[0] += dt * reduced * force * normal;
      work[1] += dt * reduced * force * face;
      changed = std::fmax(changed, std::fabs(normal + face));
      nodes.projection(a, d) += reduced / massA * (normal + face);
      nodes.projection(b, d) -= reduced / massB * (normal + face);
    }
    pairs.taken(q, 0) += work[0] + work[1];
    pairs.taken(q, 1) += pairs.springs.join(q) ? 0.0 : work[1];
    return changed;
  }
};

} // namespace

template <int D>
void exchangeImpulses(const State<D>& state, const SharedNodes<D>& shared, const NodalPairs<D>& pairs,
                      const PairLaws& laws)
{
  if (!(state.clock.dt > 0.0))
    return;
  const View<char* [D]> held("rhegma::heldSharedNodes", shared.count);
  markHeldAxes(state, shared.node, shared.count, held);
  const ExchangeImpulses<D> exchange{state.mesh.nodes,
                                     shared,
                                     pairs,
                                     laws,
                                     held,
                                     pressedPairs(state, laws.groups),
                                     stillClosed * state.mesh.grid.spacing,
                                     state.clock.dt};
  parallelForSmall("rhegma::exchangeImpulses", shared.count, exchange);
}

template <int D>
void joinProjection(const State<D>& state, const SharedNodes<D>& shared, const NodalPairs<D>& pairs)
{
  const JoinProjection<D> join{state.mesh.nodes, pairs, state.clock.dt};
  parallelForSmall("rhegma::joinProjection", shared.count, join);
}

template void joinProjection(const State<2>&, const SharedNodes<2>&, const NodalPairs<2>&);
template void joinProjection(const State<3>&, const SharedNodes<3>&, const NodalPairs<3>&);
template void exchangeImpulses(const State<2>&, const SharedNodes<2>&, const NodalPairs<2>&, const PairLaws&);
template void exchangeImpulses(const State<3>&, const SharedNodes<3>&, const NodalPairs<3>&, const PairLaws&);

} // namespace Rhegma::body_contact
