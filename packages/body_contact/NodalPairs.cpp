/// The pairs of fields of different groups at shared nodes, and what they exchange.

#include "base/SmallLoops.hpp"
#include "body_contact/NodalContact.hpp"

namespace Rhegma::body_contact
{

namespace
{

/// Number of pairs of a shared node: the two fields of its owner next to a crack are no pair.
template <int D>
KOKKOS_INLINE_FUNCTION int pairsOfNode(const SharedNodes<D>& shared, int s)
{
  const int groups = numGroups(shared.groups, shared.node(s));
  return pairsOf(groups) + (shared.second(s) < 0 ? 0 : groups - 1);
}

constexpr int mostPairs = pairsOf(mostGroups) + mostGroups - 1; ///< of a node

/// Adds a pair of fields, the group with the lower number first.
template <int D>
KOKKOS_INLINE_FUNCTION void setPair(const NodalPairs<D>& pairs, int at, int node, const int (&group)[2],
                                    const int (&row)[2])
{
  const int first = group[0] < group[1] ? 0 : 1;
  pairs.node(at) = node;
  for (int k = 0; k < 2; ++k)
  {
    const int from = k == 0 ? first : 1 - first;
    pairs.group(at, k) = group[from] - 1;
    pairs.row(at, k) = row[from];
  }
  for (int d = 0; d < D; ++d)
    pairs.impulse(at, d) = 0.0;
}

} // namespace

template <int D>
void listPairs(const SharedNodes<D>& shared, NodalPairs<D>& pairs)
{
  const int nodes = shared.count, most = mostPairs * nodes;
  if (static_cast<int>(pairs.first.extent(0)) < nodes + 1)
    pairs.first = View<int*>("rhegma::firstPairOfNode", 2 * nodes + 1);
  if (static_cast<int>(pairs.gap.extent(0)) < most)
  {
    pairs.group = View<int* [2]>("rhegma::groupsOfPairs", 2 * most);
    pairs.row = View<int* [2]>("rhegma::rowsOfPairs", 2 * most);
    pairs.node = View<int*>("rhegma::nodesOfPairs", 2 * most);
    pairs.impulse = View<double* [D]>("rhegma::impulsesOfPairs", 2 * most);
    pairs.normal = View<double* [D]>("rhegma::normalsOfPairs", 2 * most);
    pairs.gap = View<double*>("rhegma::gapsOfPairs", 2 * most);
    pairs.loses = View<double* [2]>("rhegma::lossOfPairs", 2 * most);
    pairs.aim = View<double* [D]>("rhegma::aimOfPairs", 2 * most);
    pairs.taken = View<double* [2]>("rhegma::energyOfPairs", 2 * most);
  }
  const NodalPairs<D> all = pairs;
  parallelScanSmall(
      "rhegma::listPairs", 0, nodes,
      KOKKOS_LAMBDA(const int s, int& at, const bool final) {
        const int node = shared.node(s), number = numGroups(shared.groups, node);
        if (!final)
        {
          at += pairsOfNode(shared, s);
          return;
        }
        all.first(s) = at;
        for (int a = 0; a < number; ++a)
          for (int b = a + 1; b < number; ++b)
          {
            const int group[2] = {shared.groups(node, a), shared.groups(node, b)};
            const int row[2] = {rowOfField(shared, s, a), rowOfField(shared, s, b)};
            setPair(all, at++, node, group, row);
            if (a > 0 || shared.second(s) < 0)
              continue;
            const int next[2] = {shared.second(s), row[1]};
            setPair(all, at++, node, group, next);
          }
        if (s == nodes - 1)
          all.first(nodes) = at;
      },
      pairs.count);
}

namespace
{

/// Sums over pairs: impulse, energy taken, the part of it along the faces, heat by friction and heat passed,
/// number of pairs that press.
template <int D>
struct AddPairs
{
  using value_type = double[];
  using size_type = int;
  using execution_space = ExecSpace;

  static constexpr int size = D + 5;
  int value_count = size;
  NodalPairs<D> pairs;
  int one, other; ///< groups; below 0: all

  KOKKOS_INLINE_FUNCTION bool counts(int q) const
  {
    bool pressed = false;
    for (int d = 0; d < D; ++d)
      pressed = pressed || pairs.impulse(q, d) != 0.0;
    return pressed && (one < 0 || (pairs.group(q, 0) == one && pairs.group(q, 1) == other));
  }

  KOKKOS_INLINE_FUNCTION void operator()(const int q, double* sum) const
  {
    if (!counts(q))
      return;
    for (int d = 0; d < D; ++d)
      sum[d] += pairs.impulse(q, d);
    sum[D] += pairs.taken(q, 0);
    sum[D + 1] += pairs.taken(q, 1);
    for (int k = 0; k < 2 && pairs.heat.extent(0) > 0; ++k)
      sum[D + 2 + k] += pairs.heat(q, k);
    sum[D + 4] += 1.0;
  }
};

} // namespace

template <int D>
PairSums<D> sumPairs(const NodalPairs<D>& pairs, int one, int other)
{
  AddPairs<D> add;
  add.pairs = pairs;
  add.one = one;
  add.other = other;
  double sum[AddPairs<D>::size] = {};
  Kokkos::parallel_reduce("rhegma::sumPairs", Kokkos::RangePolicy<ExecSpace>(0, pairs.count), add, sum);
  PairSums<D> sums;
  for (int d = 0; d < D; ++d)
    sums.impulse[d] = sum[d];
  sums.dissipated = sum[D];
  sums.friction = sum[D + 1];
  sums.heated = sum[D + 2];
  sums.passed = sum[D + 3];
  sums.closed = static_cast<int>(sum[D + 4]);
  Kokkos::parallel_reduce(
      "rhegma::largestOverlap", Kokkos::RangePolicy<ExecSpace>(0, pairs.count),
      KOKKOS_LAMBDA(const int q, double& most) {
        if (add.counts(q) && -pairs.gap(q) > most)
          most = -pairs.gap(q);
      },
      Kokkos::Max<double>(sums.overlap));
  sums.overlap = sums.closed > 0 ? sums.overlap : 0.0;
  return sums;
}

template void listPairs(const SharedNodes<2>&, NodalPairs<2>&);
template void listPairs(const SharedNodes<3>&, NodalPairs<3>&);
template PairSums<2> sumPairs(const NodalPairs<2>&, int, int);
template PairSums<3> sumPairs(const NodalPairs<3>&, int, int);

} // namespace Rhegma::body_contact
