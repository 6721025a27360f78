#include "body_contact/SharedNodes.hpp"

#include "base/SmallLoops.hpp"
#include "body_contact/NearBlocks.hpp"

namespace Rhegma::body_contact
{

namespace
{

/// Lowest and highest group in each block of the lattice, particles or not.
using GroupRange = View<int** [2]>;

constexpr int noGroup = 1 << 30;

/// \return blocks of the lattice along each axis that is cut
template <int D>
GroupRange groupsOfBlocks(const State<D>& state)
{
  const Grid<D>& grid = state.mesh.grid;
  const Blocks<D> blocks = state.mesh.blocks;
  GroupRange range("rhegma::groupsOfBlocks", grid.cells[grid.axisOrder[0]] / Blocks<D>::edge + 1,
                   grid.cells[grid.axisOrder[1]] / Blocks<D>::edge + 1);
  Kokkos::parallel_for(
      "rhegma::clearGroupsOfBlocks", Kokkos::RangePolicy<ExecSpace>(0, range.extent(0)),
      KOKKOS_LAMBDA(const int i) {
        for (int j = 0; j < static_cast<int>(range.extent(1)); ++j)
        {
          range(i, j, 0) = noGroup;
          range(i, j, 1) = -1;
        }
      });
  const auto bodyGroup = state.particles.integer(fields::bodyGroup);
  Kokkos::parallel_for(
      "rhegma::groupsOfBlocks", Kokkos::RangePolicy<ExecSpace>(0, blocks.numBlocks),
      KOKKOS_LAMBDA(const int b) {
        int lowest = noGroup, highest = -1;
        for (int p = blocks.first(b); p < blocks.first(b + 1); ++p)
        {
          const int group = bodyGroup(p);
          lowest = group < lowest ? group : lowest;
          highest = group > highest ? group : highest;
        }
        const int i = blocks.corner(b, 0) / Blocks<D>::edge, j = blocks.corner(b, 1) / Blocks<D>::edge;
        range(i, j, 0) = lowest;
        range(i, j, 1) = highest;
      });
  return range;
}

/// Marks the blocks that have more than one group in them and their neighbours: a particle is at most a cell
/// outside of its block and touches nodes at most three cells from its own.
template <int D>
int markNearBlocks(const Blocks<D>& blocks, const GroupRange& range, const View<char*>& nearBlock)
{
  int count = 0;
  Kokkos::parallel_reduce(
      "rhegma::markNearBlocks", Kokkos::RangePolicy<ExecSpace>(0, blocks.numBlocks),
      KOKKOS_LAMBDA(const int b, int& sum) {
        const int i = blocks.corner(b, 0) / Blocks<D>::edge, j = blocks.corner(b, 1) / Blocks<D>::edge;
        int lowest = noGroup, highest = -1;
        for (int k = -1; k <= 1; ++k)
          for (int l = -1; l <= 1; ++l)
          {
            const int at = i + k, next = j + l;
            if (at < 0 || next < 0 || at >= static_cast<int>(range.extent(0)) ||
                next >= static_cast<int>(range.extent(1)))
              continue;
            lowest = range(at, next, 0) < lowest ? range(at, next, 0) : lowest;
            highest = range(at, next, 1) > highest ? range(at, next, 1) : highest;
          }
        nearBlock(b) = lowest < highest ? 1 : 0;
        sum += nearBlock(b);
      },
      count);
  return count;
}

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

/// The group of a point: as given, or that of the bodies which the crack next to it cuts; 0: not known.
struct GroupOfPoint
{
  View<int*> group, side, ofCrack;

  KOKKOS_INLINE_FUNCTION int operator()(int r) const
  {
    const int given = group.extent(0) > 0 ? group(r) : 0, name = side(r) > 0 ? side(r) : -side(r);
    return given != 0 || name == 0 || ofCrack.extent(0) == 0 ? given : ofCrack(name - 1);
  }
};

} // namespace

template <int D>
bool areApart(const State<D>& state, SharedNodes<D>& shared)
{
  if (shared.sorts == state.particles.sorts)
    return !shared.anyNear;
  shared.sorts = state.particles.sorts;
  const Blocks<D>& blocks = state.mesh.blocks;
  shared.nearBlock = View<char*>("rhegma::blocksNearGroups", blocks.numBlocks);
  shared.anyNear = markNearBlocks(blocks, groupsOfBlocks(state), shared.nearBlock) > 0;
  return !shared.anyNear;
}

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

template <int D>
void findFieldsNextToCracks(const State<D>& state, const SharedNodes<D>& shared)
{
  if (state.cracks.bodyGroupOf.extent(0) == 0)
    return;
  const SharedNodes<D> at = shared;
  const StencilTable<D> table = state.stored.table;
  const View<int*> row = state.stored.row;
  parallelForSmall(
      "rhegma::findFieldsNextToCracks", shared.count, KOKKOS_LAMBDA(const int s) {
        const int second = at.second(s);
        for (int k = at.firstParticle(s); second >= 0 && k < at.firstParticle(s + 1); ++k)
        {
          const int r = at.field(k) == at.node(s) ? row(at.particle(k)) : -1,
                    count = r < 0 ? 0 : table.count(r);
          for (int e = 0; e < count; ++e)
            if (table.node(r, e) == second)
              at.field(k) = second;
        }
      });
}

template <int D>
void useFieldsOfGroups(const State<D>& state, const SharedNodes<D>& shared, const ObservedPoints<D>& points,
                       const StencilTable<D>& table)
{
  if (shared.indexOf.extent(0) == 0 || shared.count == 0)
    return;
  const SharedNodes<D> at = shared;
  const int lattice = state.mesh.nodes.numLattice;
  const GroupOfPoint groupOf{points.group, points.side, state.cracks.bodyGroupOf};
  parallelForSmall(
      "rhegma::useFieldsOfGroups", points.count, KOKKOS_LAMBDA(const int r) {
        const int group = groupOf(r), count = group != 0 ? table.count(r) : 0;
        for (int k = 0; k < count; ++k)
        {
          const int n = table.node(r, k);
          if (n >= lattice || at.groups(n, 0) == 0 || at.groups(n, 0) == group)
            continue;
          int field = 1;
          while (field < mostGroups && at.groups(n, field) != group)
            ++field;
          if (field < mostGroups)
          {
            table.node(r, k) = at.row(at.indexOf(n)) + field - 1;
            continue;
          }
          table.weight(r, k) = 0.0;
          for (int d = 0; d < D; ++d)
            table.slope(r, k, d) = 0.0;
        }
      });
}

template bool areApart(const State<2>&, SharedNodes<2>&);
template bool areApart(const State<3>&, SharedNodes<3>&);
template void clearSharedNodes(SharedNodes<2>&);
template void clearSharedNodes(SharedNodes<3>&);
template void findFieldsNextToCracks(const State<2>&, const SharedNodes<2>&);
template void findFieldsNextToCracks(const State<3>&, const SharedNodes<3>&);
template void findSharedNodes(State<2>&, SharedNodes<2>&, const View<int*>&);
template void findSharedNodes(State<3>&, SharedNodes<3>&, const View<int*>&);
template void useFieldsOfGroups(const State<2>&, const SharedNodes<2>&, const ObservedPoints<2>&,
                                const StencilTable<2>&);
template void useFieldsOfGroups(const State<3>&, const SharedNodes<3>&, const ObservedPoints<3>&,
                                const StencilTable<3>&);

} // namespace Rhegma::body_contact
