/// Where cracks have ended on others.

#include "combustion/Meeting.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

namespace Rhegma::combustion
{
namespace
{

constexpr double reach = 0.2; ///< two ends that are this far apart may have met

/// A crack of one straight segment.
struct Segment
{
  Vector<2> from, to;
  int atStart, atEnd; ///< what lies beyond its ends
};

CrackSet<2> cracksOf(const std::vector<Segment>& segments)
{
  const int n = static_cast<int>(segments.size());
  CrackSet<2> set;
  set.vertex = View<double* [2]>("vertex", 2 * n);
  set.simplex = View<int* [2]>("simplex", n);
  set.neighbour = View<int* [2]>("neighbour", n);
  const auto vertex = Kokkos::create_mirror_view(set.vertex);
  const auto simplex = Kokkos::create_mirror_view(set.simplex);
  const auto neighbour = Kokkos::create_mirror_view(set.neighbour);
  for (int c = 0; c < n; ++c)
  {
    set.cracks.push_back({"Crack", 2 * c, 2, c, 1});
    for (int d = 0; d < 2; ++d)
    {
      vertex(2 * c, d) = segments[c].from[d];
      vertex(2 * c + 1, d) = segments[c].to[d];
      simplex(c, d) = 2 * c + d;
    }
    neighbour(c, 1) = segments[c].atStart;
    neighbour(c, 0) = segments[c].atEnd;
  }
  Kokkos::deep_copy(set.vertex, vertex);
  Kokkos::deep_copy(set.simplex, simplex);
  Kokkos::deep_copy(set.neighbour, neighbour);
  return set;
}

/// Crack, end, other, otherEnd of each, in order.
std::vector<std::array<int, 4>> meetingsOf(const std::vector<Segment>& segments)
{
  std::vector<std::array<int, 4>> all;
  for (const Meeting& m : findMeetings(cracksOf(segments), reach))
    all.push_back({m.crack, m.end, m.other, m.otherEnd});
  std::sort(all.begin(), all.end());
  return all;
}

using Meetings = std::vector<std::array<int, 4>>;

} // namespace

TEST(Meeting, OfTwoEndsIsCountedOnce)
{
  const Segment left{{0.0, 0.0}, {1.0, 0.0}, facet::surfaceBreaking, facet::joined},
      right{{1.05, 0.0}, {2.0, 0.0}, facet::joined, facet::surfaceBreaking};
  EXPECT_EQ(meetingsOf({left, right}), (Meetings{{0, 1, 1, 0}}));
  EXPECT_EQ(meetingsOf({right, left}), (Meetings{{0, 0, 1, 1}}));
}

/// Two cracks end on one another's neighbour close to each other: the end that is near belongs to another
/// meeting, whichever crack is named first.
TEST(Meeting, NextToAnEndThatLiesOnAThirdCrackIsNotWithThatEnd)
{
  const Segment along{{0.0, 0.0}, {1.0, 0.0}, facet::surfaceBreaking, facet::joined},
      across{{1.0, -1.0}, {1.0, 1.0}, facet::surfaceBreaking, facet::surfaceBreaking},
      above{{0.9, 1.0}, {0.9, 0.0}, facet::surfaceBreaking, facet::joined};
  EXPECT_EQ(meetingsOf({along, across, above}), (Meetings{{0, 1, 1, -1}, {2, 1, 0, -1}}));
  EXPECT_EQ(meetingsOf({above, across, along}), (Meetings{{0, 1, 2, -1}, {2, 1, 1, -1}}));
}

} // namespace Rhegma::combustion
