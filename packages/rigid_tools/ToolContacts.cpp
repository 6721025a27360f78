#include "rigid_tools/ToolContacts.hpp"

#include "base/SmallLoops.hpp"
#include "rigid_tools/ContactParts.hpp"
#include "transfer/ParticleViews.hpp"
#include "transfer/PressedNodes.hpp"

#include <algorithm>
#include <utility>

namespace Rhegma::rigid_tools
{

namespace
{

/// Particles with a smaller weight at a node do not count there: rounding decides whether they touch it.
constexpr double leastWeight = 1e-9;

/// Distance from the surface up to which nodes are in contact [cells]. With a whole cell disks roll too
/// slowly, by 8 % with 16 cells in the radius instead of 2 %; with none bodies sink in where a node is just
/// outside.
constexpr double contactReach = 0.5;

/// Overlap at which the distance is a whole cell [cells]: corners of bodies, in which little stress resists,
/// would sink in between nodes.
constexpr double deepOverlap = 0.1;

/// Whether a node is close enough to the plane through the foot of a particle.
template <int D>
KOKKOS_INLINE_FUNCTION bool isInReach(const ParticleGaps<D>& gaps, int k, const Vector<D>& node)
{
  double distance = 0.0;
  for (int d = 0; d < D; ++d)
    distance += (node[d] - gaps.foot(k, d)) * gaps.normal(k, d);
  const double deep = -gaps.gap(k) / (deepOverlap * gaps.spacing(k));
  const double more = deep > 1.0 ? 1.0 : deep > 0.0 ? deep : 0.0;
  return distance <= (contactReach + more * (1.0 - contactReach)) * gaps.spacing(k);
}

/// Whether a particle touches the tool at a node.
template <int D>
KOKKOS_INLINE_FUNCTION bool touchesAt(const ParticleGaps<D>& gaps, int k, const PressedNodes& pressed,
                                      int node)
{
  return gaps.gap(k) <= (pressed(node) ? stillClosed * gaps.spacing(k) : 0.0);
}

/// Marks the rows to which particles that touch the tool add.
template <int D, class Connect>
struct MarkRows
{
  Connect connect;
  ParticleGaps<D> gaps;
  Nodes<D> nodes;
  NodePositions<D> positions;
  View<int*> indexOfRow;
  View<int*> marked; ///< marked rows, in no order
  View<int> numMarked;
  PressedNodes pressed;

  KOKKOS_INLINE_FUNCTION void operator()(const int k) const
  {
    if (gaps.gap(k) > stillClosed * gaps.spacing(k))
      return;
    connect.visit(gaps.particle(k),
                  [&](int row, double weight, const double*)
                  {
                    const int node = latticeNode(nodes, row);
                    if (weight > leastWeight && touchesAt(gaps, k, pressed, node) &&
                        isInReach(gaps, k, positions(node)))
                      mark(row);
                  });
  }

  KOKKOS_INLINE_FUNCTION void mark(int row) const
  {
    if (Kokkos::atomic_exchange(&indexOfRow(row), 0) < 0)
      marked(Kokkos::atomic_fetch_add(&numMarked(), 1)) = row;
  }
};

/// Counts the particles of each contact, or lists them.
template <int D, class Connect>
struct ListParticles
{
  Connect connect;
  ParticleGaps<D> gaps;
  ToolContacts<D> contacts;
  View<int*> number; ///< of each contact, so far
  bool lists;

  KOKKOS_INLINE_FUNCTION void operator()(const int k) const
  {
    connect.visit(gaps.particle(k),
                  [&](int row, double weight, const double*)
                  {
                    const int contact = contacts.indexOfRow(row);
                    if (contact < 0 || !(weight > leastWeight))
                      return;
                    const int place = Kokkos::atomic_fetch_add(&number(contact), 1);
                    if (!lists)
                      return;
                    const int at = contacts.first(contact) + place;
                    contacts.particle(at) = k;
                    contacts.weight(at) = weight;
                  });
  }
};

/// Finds normal, gap and arm of a contact from its particles.
template <int D>
struct MeasureContact
{
  ParticleGaps<D> gaps;
  ToolContacts<D> contacts;
  BorrowedView<double* [D]> position;
  NodePositions<D> positions;
  PressedNodes pressed;
  Vector<D> centre; ///< of rotation, now [m]

  KOKKOS_INLINE_FUNCTION void operator()(const int c) const
  {
    const int begin = contacts.first(c), end = contacts.first(c + 1);
    sortParticles(begin, end);
    const Vector<D> node = positions(contacts.node(c));
    double nearest = 1e300;
    for (int e = begin; e < end; ++e)
      nearest = std::fmin(nearest, distanceFromLine(contacts.particle(e), node));
    Vector<D> normal{}, foot{};
    double gap = 1e300, weights = 0.0;
    for (int e = begin; e < end; ++e)
    {
      const int k = contacts.particle(e);
      const double window = (1.0 + 1e-6) * std::fmax(0.5 * gaps.spacing(k), nearest);
      if (!touchesAt(gaps, k, pressed, contacts.node(c)) || distanceFromLine(k, node) > window ||
          !isInReach(gaps, k, node))
        continue;
      const Vector<D> out = normalOf(k);
      double height = 0.0; // of the node above the plane through the foot of the particle
      for (int d = 0; d < D; ++d)
        height += (node[d] - gaps.foot(k, d)) * out[d];
      normal = normal + contacts.weight(e) * out;
      foot = foot + contacts.weight(e) * (node - height * out);
      weights += contacts.weight(e);
      gap = std::fmin(gap, gaps.gap(k));
    }
    const double length = norm(normal);
    for (int d = 0; d < D; ++d)
    {
      contacts.normal(c, d) = length > 0.0 ? normal[d] / length : 0.0;
      contacts.arm(c, d) = weights > 0.0 ? foot[d] / weights - centre[d] : 0.0;
      contacts.impulse(c, d) = 0.0;
      contacts.held(c, d) = 0;
    }
    contacts.gap(c) = gap;
    contacts.sticks(c) = 0;
  }

  /// In the order of their numbers, so that sums do not depend on the threads.
  KOKKOS_INLINE_FUNCTION void sortParticles(int begin, int end) const
  {
    for (int e = begin + 1; e < end; ++e)
    {
      const int k = contacts.particle(e);
      const double weight = contacts.weight(e);
      int at = e;
      for (; at > begin && contacts.particle(at - 1) > k; --at)
      {
        contacts.particle(at) = contacts.particle(at - 1);
        contacts.weight(at) = contacts.weight(at - 1);
      }
      contacts.particle(at) = k;
      contacts.weight(at) = weight;
    }
  }

  KOKKOS_INLINE_FUNCTION Vector<D> normalOf(int k) const
  {
    Vector<D> n;
    for (int d = 0; d < D; ++d)
      n[d] = gaps.normal(k, d);
    return n;
  }

  /// Distance of a particle from the line through the node along its normal [m].
  KOKKOS_INLINE_FUNCTION double distanceFromLine(int k, const Vector<D>& node) const
  {
    Vector<D> x;
    for (int d = 0; d < D; ++d)
      x[d] = position(gaps.particle(k), d) - node[d];
    const Vector<D> n = normalOf(k);
    return norm(x - dot(x, n) * n);
  }
};

template <int D>
void reserve(ToolContacts<D>& contacts, int count)
{
  if (static_cast<int>(contacts.gap.extent(0)) >= count)
    return;
  const int rows = 2 * count;
  contacts.row = View<int*>("rhegma::rowsAtTool", rows);
  contacts.node = View<int*>("rhegma::nodesAtTool", rows);
  contacts.normal = View<double* [D]>("rhegma::normalsAtTool", rows);
  contacts.arm = View<double* [D]>("rhegma::armsOfTool", rows);
  contacts.gap = View<double*>("rhegma::gapsAtTool", rows);
  contacts.held = View<char* [D]>("rhegma::heldAtTool", rows);
  contacts.impulse = View<double* [D]>("rhegma::impulsesOfTool", rows);
  contacts.wanted = View<double* [D]>("rhegma::wantedImpulsesOfTool", rows);
  contacts.sticks = View<char*>("rhegma::stickingAtTool", rows);
  contacts.taken = View<double* [2]>("rhegma::energyAtTool", rows);
  contacts.work = View<double*>("rhegma::workOfTool", rows);
  contacts.parts = View<int*>("rhegma::partsAtTool", rows);
  contacts.partRow = View<int * [1 << D]>("rhegma::rowsOfPartsAtTool", rows);
  contacts.part = View<double * [1 << D]>("rhegma::partAtTool", rows);
  contacts.mass = View<double*>("rhegma::massAtTool", rows);
  contacts.first = View<int*>("rhegma::firstParticleAtTool", rows + 1);
}

/// Numbers the marked rows in their order, so that sums do not depend on the threads.
template <int D>
void numberRows(const State<D>& state, ToolContacts<D>& contacts, int count)
{
  contacts.count = count;
  reserve(contacts, count);
  if (count == 0)
    return;
  const auto range = std::make_pair(0, count);
  const auto listed = Kokkos::subview(contacts.marked, range);
  const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, listed);
  std::sort(host.data(), host.data() + count);
  Kokkos::deep_copy(Kokkos::subview(contacts.row, range), host);
  const Nodes<D> nodes = state.mesh.nodes;
  const View<int*> index = contacts.indexOfRow, rowOf = contacts.row, nodeOf = contacts.node;
  parallelForSmall(
      "rhegma::numberRowsAtTool", count, KOKKOS_LAMBDA(const int c) {
        index(rowOf(c)) = c;
        nodeOf(c) = latticeNode(nodes, rowOf(c));
      });
}

template <int D>
void listParticles(const State<D>& state, const ParticleGaps<D>& gaps, ToolContacts<D>& contacts)
{
  const View<int*> number("rhegma::particlesOfContacts", contacts.count);
  const auto pass = [&](bool lists)
  {
    withConnectivity(state,
                     [&](const auto& connect)
                     {
                       using Connect = std::decay_t<decltype(connect)>;
                       parallelForSmall("rhegma::listParticlesOfContacts", gaps.count,
                                        ListParticles<D, Connect>{connect, gaps, contacts, number, lists});
                     });
  };
  pass(false);
  const View<int*> first = contacts.first;
  const int count = contacts.count;
  int all = 0;
  parallelScanSmall(
      "rhegma::particlesBeforeContacts", 0, count,
      KOKKOS_LAMBDA(const int c, int& at, const bool final) {
        const int own = number(c);
        if (final)
        {
          first(c) = at;
          number(c) = 0;
          if (c == count - 1)
            first(count) = at + own;
        }
        at += own;
      },
      all);
  if (static_cast<int>(contacts.particle.extent(0)) < all)
  {
    contacts.particle = View<int*>("rhegma::particlesOfContacts", 2 * all);
    contacts.weight = View<double*>("rhegma::weightsOfContacts", 2 * all);
  }
  pass(true);
}

/// Clears the marks of the rows.
template <int D>
void clearMarks(const ToolContacts<D>& contacts)
{
  const ToolContacts<D> at = contacts;
  parallelForSmall(
      "rhegma::clearRowsAtTool", contacts.count,
      KOKKOS_LAMBDA(const int c) { at.indexOfRow(at.row(c)) = -1; });
}

} // namespace

template <int D>
void listContacts(const State<D>& state, const Tool<D>& tool, const ParticleGaps<D>& gaps,
                  ToolContacts<D>& contacts)
{
  contacts.count = 0;
  if (gaps.touching == 0)
    return;
  const Nodes<D> nodes = state.mesh.nodes;
  const int rows = static_cast<int>(nodes.sums.extent(0));
  if (static_cast<int>(contacts.indexOfRow.extent(0)) < rows)
  {
    contacts.indexOfRow = View<int*>("rhegma::contactsOfRows", rows);
    contacts.marked = View<int*>("rhegma::markedRowsAtTool", rows);
    Kokkos::deep_copy(contacts.indexOfRow, -1);
  }
  const PressedNodes pressed = pressedNodes(state, tool.name());
  const Vector<D> centre = tool.placement().centre + tool.placement().moved;
  const NodePositions<D> positions = nodePositions(state);
  const View<int*> index = contacts.indexOfRow, marked = contacts.marked;
  const View<int> numMarked("rhegma::numMarkedRowsAtTool");
  withConnectivity(state,
                   [&](const auto& connect)
                   {
                     using Connect = std::decay_t<decltype(connect)>;
                     parallelForSmall("rhegma::markRowsAtTool", gaps.count,
                                      MarkRows<D, Connect>{connect, gaps, nodes, positions, index, marked,
                                                           numMarked, pressed});
                   });
  numberRows(state, contacts, onHost(numMarked)());
  if (contacts.count == 0)
    return;
  listParticles(state, gaps, contacts);
  parallelForSmall("rhegma::measureContacts", contacts.count,
                   MeasureContact<D>{gaps, contacts, state.particles.template real<D>(fields::position),
                                     positions, pressed, centre});
  clearMarks(contacts);
  divideContacts(state, centre, contacts);
}

template void listContacts(const State<2>&, const Tool<2>&, const ParticleGaps<2>&, ToolContacts<2>&);
template void listContacts(const State<3>&, const Tool<3>&, const ParticleGaps<3>&, ToolContacts<3>&);

} // namespace Rhegma::rigid_tools
