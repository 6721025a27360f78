#pragma once
/// Nodes that several groups of bodies touch, and the field of each group at them. The group of a particle is
/// its field bodyGroup: a number from 1 on.

#include "body_contact/MeetingCells.hpp"
#include "state/BodyGroup.hpp"

namespace Rhegma::body_contact
{

/// Groups that may touch a node.
constexpr int mostGroups = 4;

/// Particles with a smaller weight at a node do not count for the gap there: rounding decides whether they
/// touch it.
constexpr double leastWeight = 1e-9;

/// Number of pairs of so many groups.
KOKKOS_INLINE_FUNCTION constexpr int pairsOf(int groups) { return groups * (groups - 1) / 2; }

/// The nodes that several groups touch in this step. At such a node one group owns the node's own row, and
/// each other one has an enriched field, in the order of their numbers. The owner is the group that a crack
/// cuts at the node, else the lowest number of those that have a crack, else the lowest number. Next to a
/// crack the owner has an enriched field, too, that of the crack (CrackSet::enrichedField), whether or not it
/// is massless.
template <int D>
struct SharedNodes
{
  long sorts = -1;        ///< Particles::sorts for which nearBlock holds
  View<char*> nearBlock;  ///< of each block of cells: not 0 where another group may be in reach
  bool anyNear = false;   ///< whether there is such a block
  MeetingCells cells;     ///< in which particles may touch a shared node
  View<int[1]> overflows; ///< not 0 where that is so

  View<int* [mostGroups]> groups; ///< of each lattice node: those that touch it, the owner first, then zeros
  View<int*> indexOf;             ///< of each lattice node: its index in `node`, or -1
  View<int*> node;                ///< the shared nodes
  View<int*> row;                 ///< of each: row of the field of its second group
  View<int*> second;              ///< of each: row of its owner's enriched field next to a crack, or -1
  int count = 0;                  ///< number of shared nodes
  int fields = 0;                 ///< number of enriched fields

  View<char*> touching;     ///< of the particles of marked blocks: not 0 for those at a shared node
  View<int*> firstParticle; ///< particles that touch shared node s: particle(firstParticle(s)) ..
  View<int*> particle;      ///< particle(firstParticle(s + 1) - 1), in the order of blocks
  View<int*> field;         ///< row of the field of each of these at its node
};

/// Number of groups that touch a node.
KOKKOS_INLINE_FUNCTION int numGroups(const View<int* [mostGroups]>& groups, int node)
{
  int count = 0;
  while (count < mostGroups && groups(node, count) != 0)
    ++count;
  return count;
}

/// Row of the field of the k-th group of shared node s, of the owner the node's own row.
template <int D>
KOKKOS_INLINE_FUNCTION int rowOfField(const SharedNodes<D>& shared, int s, int k)
{
  return k == 0 ? shared.node(s) : shared.row(s) + k - 1;
}

/// Whether no two groups are near each other, so that no node is shared. Looks at the blocks of cells after
/// each sort.
template <int D>
bool areApart(const State<D>& state, SharedNodes<D>& shared);

/// Finds the shared nodes, gives their fields rows, lists the particles at them, and marks the particles that
/// touch an enriched field (row = 0). Sets the state's failure where too many groups meet at a node.
template <int D>
void findSharedNodes(State<D>& state, SharedNodes<D>& shared, const View<int*>& row);

/// Forgets the shared nodes of an earlier step.
template <int D>
void clearSharedNodes(SharedNodes<D>& shared);

/// Finds the field of the particles at shared nodes next to a crack, from their stored stencils.
template <int D>
void findFieldsNextToCracks(const State<D>& state, const SharedNodes<D>& shared);

/// Replaces shared nodes in stencils by the field of the point's group there, after cracks have replaced
/// nodes by their enriched fields. Points without a group keep their nodes, others get no weight of nodes
/// that their group does not touch.
template <int D>
void useFieldsOfGroups(const State<D>& state, const SharedNodes<D>& shared, const ObservedPoints<D>& points,
                       const StencilTable<D>& table);

} // namespace Rhegma::body_contact
