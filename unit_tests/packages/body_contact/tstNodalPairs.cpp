/// The list of pairs of fields at shared nodes, as the nodes and the groups at them become more.

#include "body_contact/NodalContact.hpp"

#include <gtest/gtest.h>

namespace Rhegma::body_contact
{

namespace
{

/// Shared nodes that are all touched by the same number of groups.
SharedNodes<2> sharedNodes(int count, int groups)
{
  SharedNodes<2> shared;
  shared.count = count;
  shared.groups = View<int* [mostGroups]>("groups", count);
  shared.node = View<int*>("node", count);
  shared.row = View<int*>("row", count);
  shared.second = View<int*>("second", count);
  const auto groupsOf = Kokkos::create_mirror_view(shared.groups);
  const auto node = Kokkos::create_mirror_view(shared.node);
  for (int s = 0; s < count; ++s)
  {
    node(s) = s;
    for (int k = 0; k < groups; ++k)
      groupsOf(s, k) = k + 1;
  }
  Kokkos::deep_copy(shared.groups, groupsOf);
  Kokkos::deep_copy(shared.node, node);
  Kokkos::deep_copy(shared.second, -1);
  return shared;
}

} // namespace

TEST(NodalPairs, HaveRoomForAllAsNodesAndGroupsBecomeMore)
{
  NodalPairs<2> pairs;
  for (const int nodes : {1, 2, 10, 17, 40, 5})
    for (int groups = 2; groups <= mostGroups; ++groups)
    {
      listPairs(sharedNodes(nodes, groups), pairs);
      const int expected = nodes * groups * (groups - 1) / 2;
      ASSERT_EQ(pairs.count, expected) << nodes << " nodes with " << groups << " groups";
      for (const std::size_t room :
           {pairs.group.extent(0), pairs.row.extent(0), pairs.impulse.extent(0), pairs.normal.extent(0),
            pairs.gap.extent(0), pairs.loses.extent(0), pairs.aim.extent(0), pairs.taken.extent(0)})
        ASSERT_GE(static_cast<int>(room), expected) << nodes << " nodes with " << groups << " groups";
    }
}

} // namespace Rhegma::body_contact
