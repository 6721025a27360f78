#include "body_contact/SharedNodes.hpp"

#include "base/SmallLoops.hpp"
#include "body_contact/NearBlocks.hpp"

namespace Rhegma::body_contact
{

namespace
{

/// Adds the group of a particle to the nodes that it touches.
template <int D, class Connect>
struct ListGroups
{
  Connect connect;
  BorrowedView<int*> bodyGroup;
  View<int* [mostGroups]> groups;
  View<int[1]> overflows;

  KOKKOS_INLINE_FUNCTION void operator()(int p) const
  {
    const int group = bodyGroup(p);
    connect.visit(p,
                  [&](int node, double weight, const double* slope)
                  {
                    if (touches<D>(weight, slope) && !insert(node, group))
                      Kokkos::atomic_exchange(&overflows(0), 1);
                  });
  }

  /// Keeps the groups of a node in their order. \return whether there was a place
  KOKKOS_INLINE_FUNCTION bool insert(int node, int group) const
  {
    for (int k = 0; k < mostGroups && group != 0; ++k)
    {
      const int there = groups(node, k);
      if (there == group)
        return true;
      if (there == 0 || there > group)
      {
        groups(node, k) = group;
        group = there;
      }
    }
    return group == 0;
  }
};

template <int D>
void listGroups(const State<D>& state, const SharedNodes<D>& shared)
{
  withUnbrokenStencils(state,
                       [&](const auto& connect)
                       {
                         using Connect = std::decay_t<decltype(connect)>;
                         forEachParticleIn("rhegma::listGroups", state, shared.nearBlock, shared.cells.meets,
                                           ListGroups<D, Connect>{connect,
                                                                  state.particles.integer(fields::bodyGroup),
                                                                  shared.groups, shared.overflows});
                       });
}

/// Numbers the shared nodes. \return their number, and that of their enriched fields in `fields`
template <int D>
int numberSharedNodes(const State<D>& state, const SharedNodes<D>& shared, int& fields)
{
  const Nodes<D> nodes = state.mesh.nodes;
  const View<int* [mostGroups]> groups = shared.groups;
  const View<int*> indexOf = shared.indexOf;
  int count = 0;
  Kokkos::parallel_scan(
      "rhegma::numberSharedNodes", Kokkos::RangePolicy<ExecSpace>(0, nodes.active.extent(0)),
      KOKKOS_LAMBDA(const int i, int& at, const bool final) {
        const int n = nodes.active(i);
        const bool several = groups(n, 1) != 0;
        if (final)
          indexOf(n) = several ? at : -1;
        at += several ? 1 : 0;
      },
      count);
  fields = 0;
  Kokkos::parallel_reduce(
      "rhegma::countFieldsOfGroups", Kokkos::RangePolicy<ExecSpace>(0, nodes.active.extent(0)),
      KOKKOS_LAMBDA(const int i, int& sum) {
        const int number = numGroups(groups, nodes.active(i));
        sum += number > 1 ? number - 1 : 0;
      },
      fields);
  return count;
}

/// Puts the owner of each node first, the others after it in their order.
template <int D>
void putOwnersFirst(const State<D>& state, const SharedNodes<D>& shared)
{
  const View<int*> cut = state.cracks.bodyGroupOf, side = state.cracks.nodeSide;
  if (cut.extent(0) == 0)
    return;
  const Nodes<D> nodes = state.mesh.nodes;
  const View<int* [mostGroups]> groups = shared.groups;
  Kokkos::parallel_for(
      "rhegma::putOwnersFirst", Kokkos::RangePolicy<ExecSpace>(0, nodes.active.extent(0)),
      KOKKOS_LAMBDA(const int i) {
        const int n = nodes.active(i);
        if (groups(n, 1) == 0)
          return;
        const int crack = side(n) > 0 ? side(n) - 1 : -side(n) - 1, here = crack < 0 ? 0 : cut(crack);
        int owner = 0, best = 0; // 2: cut here, 1: cut somewhere
        for (int k = numGroups(groups, n) - 1; k >= 0; --k)
        {
          int rank = groups(n, k) == here ? 2 : 0;
          for (int c = 0; c < static_cast<int>(cut.extent(0)) && rank == 0; ++c)
            rank = groups(n, k) == cut(c) ? 1 : 0;
          owner = rank >= best ? k : owner;
          best = rank >= best ? rank : best;
        }
        const int first = groups(n, owner);
        for (int k = owner; k > 0; --k)
          groups(n, k) = groups(n, k - 1);
        groups(n, 0) = first;
      });
}

/// Gives the fields of other groups than the owners rows.
template <int D>
void claimRows(State<D>& state, SharedNodes<D>& shared)
{
  state.mesh.nodes.claimEnriched(shared.fields);
  if (static_cast<int>(shared.node.extent(0)) < shared.count)
  {
    shared.node = View<int*>("rhegma::sharedNode", 2 * shared.count);
    shared.row = View<int*>("rhegma::sharedNodeRow", 2 * shared.count);
    shared.second = View<int*>("rhegma::secondFieldOfSharedNode", 2 * shared.count);
    shared.firstParticle = View<int*>("rhegma::firstParticleOfNode", 2 * shared.count + 1);
  }
}

template <int D>
void fillRows(const State<D>& state, const SharedNodes<D>& shared)
{
  const Nodes<D> nodes = state.mesh.nodes;
  const View<int* [mostGroups]> groups = shared.groups;
  const View<int*> indexOf = shared.indexOf, node = shared.node, row = shared.row, second = shared.second;
  const View<int*> cut = state.cracks.bodyGroupOf, side = state.cracks.nodeSide,
                   ofCrack = state.cracks.enrichedField;
  const bool cracked = cut.extent(0) > 0;
  const int claimed = nodes.numEnriched - shared.fields;
  int count = 0;
  Kokkos::parallel_scan(
      "rhegma::rowsOfSharedNodes", Kokkos::RangePolicy<ExecSpace>(0, nodes.active.extent(0)),
      KOKKOS_LAMBDA(const int i, int& at, const bool final) {
        const int n = nodes.active(i), s = indexOf(n);
        if (s < 0)
          return;
        const int extra = numGroups(groups, n) - 1;
        if (final)
        {
          node(s) = n;
          row(s) = nodes.numLattice + claimed + at;
          for (int k = 0; k < extra; ++k)
            nodes.parent(claimed + at + k) = n;
          const int name = cracked ? side(n) : 0, crack = name > 0 ? name - 1 : -name - 1;
          second(s) = crack >= 0 && cut(crack) == groups(n, 0) ? ofCrack(n) : -1;
        }
        at += extra;
      },
      count);
}

/// Counts the particles at shared nodes, or lists them from the end of each node's range on backwards; marks
/// those that touch an enriched field.
template <int D, class Connect>
struct ListParticles
{
  Connect connect;
  BorrowedView<int*> bodyGroup;
  SharedNodes<D> shared;
  View<int*> number;    ///< of each shared node
  View<char*> touching; ///< of particles: not 0 where the first pass found a shared node
  View<int*> row;       ///< of particles
  bool lists;

  KOKKOS_INLINE_FUNCTION void operator()(int p) const
  {
    if (lists && touching(p) == 0)
      return;
    const int group = bodyGroup(p);
    bool enriched = false, any = false;
    connect.visit(p,
                  [&](int node, double weight, const double* slope)
                  {
                    const int s = shared.indexOf(node);
                    if (s < 0 || !touches<D>(weight, slope))
                      return;
                    enriched = enriched || shared.groups(node, 0) != group;
                    any = true;
                    if (!(weight > leastWeight))
                      return;
                    if (lists)
                    {
                      const int at = shared.firstParticle(s) + number(s);
                      shared.particle(at) = p;
                      shared.field(at) = rowOfField(shared, s, placeOf(node, group));
                    }
                    ++number(s);
                  });
    if (!lists)
      touching(p) = any ? 1 : 0;
    if (enriched)
      row(p) = 0;
  }

  /// The place of a group among those of a node.
  KOKKOS_INLINE_FUNCTION int placeOf(int node, int group) const
  {
    int k = 0;
    while (k + 1 < mostGroups && shared.groups(node, k) != group)
      ++k;
    return k;
  }
};

template <int D>
void listParticles(const State<D>& state, SharedNodes<D>& shared, const View<int*>& row)
{
  const View<int*> number("rhegma::particlesOfNode", shared.count);
  if (static_cast<int>(shared.touching.extent(0)) < state.particles.size())
    shared.touching = View<char*>("rhegma::particlesAtSharedNodes", state.particles.size());
  const auto pass = [&](bool lists)
  {
    withUnbrokenStencils(state,
                         [&](const auto& connect)
                         {
                           using Connect = std::decay_t<decltype(connect)>;
                           forEachParticleIn(
                               "rhegma::particlesOfNodes", state, shared.nearBlock, shared.cells.meets,
                               ListParticles<D, Connect>{connect, state.particles.integer(fields::bodyGroup),
                                                         shared, number, shared.touching, row, lists});
                         });
  };
  pass(false);
  const View<int*> first = shared.firstParticle;
  const int count = shared.count;
  int all = 0;
  Kokkos::parallel_scan(
      "rhegma::particlesBeforeNodes", Kokkos::RangePolicy<ExecSpace>(0, count),
      KOKKOS_LAMBDA(const int s, int& at, const bool final) {
        const int own = number(s);
        if (final)
        {
          first(s) = at;
          number(s) = 0;
          if (s == count - 1)
            first(count) = at + own;
        }
        at += own;
      },
      all);
  if (static_cast<int>(shared.particle.extent(0)) < all)
  {
    shared.particle = View<int*>("rhegma::particlesOfNodes", 2 * all);
    shared.field = View<int*>("rhegma::fieldsOfParticles", 2 * all);
  }
  pass(true);
}

/// Clears the marks of nodes that particles can reach, and makes room for them.
template <int D>
void clearNodeMarks(const State<D>& state, SharedNodes<D>& shared)
{
  if (static_cast<int>(shared.indexOf.extent(0)) < state.mesh.nodes.numLattice)
  {
    shared.groups = View<int* [mostGroups]>("rhegma::groupsOfNodes", state.mesh.nodes.numLattice);
    shared.indexOf = View<int*>("rhegma::sharedNodeIndex", state.mesh.nodes.numLattice);
    shared.overflows = View<int[1]>("rhegma::groupOverflows");
    Kokkos::deep_copy(shared.indexOf, -1);
  }
  const Nodes<D> nodes = state.mesh.nodes;
  const View<int* [mostGroups]> groups = shared.groups;
  const View<int*> indexOf = shared.indexOf;
  Kokkos::parallel_for(
      "rhegma::clearGroupsOfNodes", Kokkos::RangePolicy<ExecSpace>(0, nodes.active.extent(0)),
      KOKKOS_LAMBDA(const int i) {
        const int n = nodes.active(i);
        indexOf(n) = -1;
        for (int k = 0; k < mostGroups; ++k)
          groups(n, k) = 0;
      });
}

} // namespace

template <int D>
void clearSharedNodes(SharedNodes<D>& shared)
{
  // Stencils of points are edited by these marks.
  if (shared.indexOf.extent(0) > 0 && shared.count > 0)
  {
    Kokkos::deep_copy(shared.indexOf, -1);
    Kokkos::deep_copy(shared.groups, 0);
  }
  shared.count = shared.fields = 0;
}

template <int D>
void findSharedNodes(State<D>& state, SharedNodes<D>& shared, const View<int*>& row)
{
  clearNodeMarks(state, shared);
  findMeetingCells(state, shared.nearBlock, shared.cells);
  listGroups(state, shared);
  putOwnersFirst(state, shared);
  shared.count = numberSharedNodes(state, shared, shared.fields);
  if (onHost(shared.overflows)(0) != 0 && state.failure.empty())
    state.failure = "more than " + std::to_string(mostGroups) +
                    " bodies meet at a node, for which Body Contact has no fields; use smaller cells";
  claimRows(state, shared);
  if (shared.count == 0)
    return;
  fillRows(state, shared);
  listParticles(state, shared, row);
}

template void clearSharedNodes(SharedNodes<2>&);
template void clearSharedNodes(SharedNodes<3>&);
template void findSharedNodes(State<2>&, SharedNodes<2>&, const View<int*>&);
template void findSharedNodes(State<3>&, SharedNodes<3>&, const View<int*>&);

} // namespace Rhegma::body_contact
