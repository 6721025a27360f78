#include "JointScene.hpp"

#include "transfer/FacePoints.hpp"

#include <algorithm>
#include <cmath>

using namespace Rhegma;
using namespace Rhegma::contact::test;

TEST(FacePoints, StandForTheWholeCrack)
{
  const auto run = barAtRest();
  FacePoints<2> points;
  EXPECT_TRUE(points.update(run->state()));
  EXPECT_FALSE(points.update(run->state())) << "the crack has not changed";
  const auto length = onHost(points.size);
  const auto current = onHost(points.currentSize);
  const auto normal = onHost(points.normal);
  const auto separation = onHost(points.separation);
  double total = 0.0;
  for (int k = 0; k < points.count(); ++k)
  {
    total += length(k);
    EXPECT_LE(length(k), 0.5 * cell * (1.0 + 1e-6));
    EXPECT_NEAR(current(k), length(k), 1e-15);
    EXPECT_NEAR(normal(k, 0), 0.0, 1e-15);
    EXPECT_NEAR(normal(k, 1), 1.0, 1e-15);
    EXPECT_NEAR(separation(k), 0.0, 1e-15);
  }
  // The crack is cut off where the body ends, known to half a diagonal of the particles, which are half a
  // cell wide.
  EXPECT_GE(total, width);
  EXPECT_LE(total, width + 2.0 * 0.36 * cell);
}

TEST(FacePoints, SeeOnlyTheirOwnSide)
{
  const auto run = barAtRest();
  State<2>& state = run->state();
  FacePoints<2> points;
  points.update(state);
  moveSides(state, {1.0, 2.0}, {-3.0, 5.0});
  const auto projection = onHost(state.mesh.nodes.projection);
  const auto count = onHost(points.above.count);
  const auto node = onHost(points.above.node);
  const auto weight = onHost(points.above.weight);
  const auto nodeBelow = onHost(points.below.node);
  const auto countBelow = onHost(points.below.count);
  for (int k = 0; k < points.count(); ++k)
  {
    ASSERT_GT(count(k), 0);
    ASSERT_GT(countBelow(k), 0);
    double sum = 0.0;
    for (int e = 0; e < count(k); ++e)
    {
      sum += weight(k, e);
      EXPECT_EQ(projection(node(k, e), 0), 1.0);
    }
    EXPECT_NEAR(sum, 1.0, 1e-15);
    for (int e = 0; e < countBelow(k); ++e)
      EXPECT_EQ(projection(nodeBelow(k, e), 0), -3.0);
  }
}

TEST(FacePoints, FollowFacesThatPart)
{
  const auto run = barAtRest();
  State<2>& state = run->state();
  FacePoints<2> points;
  points.update(state);
  const auto face = onHost(state.cracks.face);
  for (std::size_t v = 0; v < face.extent(0); ++v)
  {
    face(v, 0, 1) -= 1e-4;
    face(v, 1, 1) += 1e-4;
  }
  Kokkos::deep_copy(state.cracks.face, face);
  points.update(state);
  const auto separation = onHost(points.separation);
  for (int k = 0; k < points.count(); ++k)
    EXPECT_NEAR(separation(k), 2e-4, 1e-16);
}

/// Cells that become smaller by two levels at once cut each piece into up to four, whose middles lie within
/// it: all of them inherit from the point of that piece, and each of the earlier points has heirs when cells
/// are coarsened.
TEST(FacePoints, InheritAcrossTwoLevelsAtOnce)
{
  const auto coarse = barAtRest(), fine = barAtRest({}, 2);
  FacePoints<2> points;
  points.update(coarse->state());
  const auto check = [&points](const State<2>& state)
  {
    const auto oldPosition = onHost(points.position);
    const auto oldSize = onHost(points.size);
    const int old = points.count();
    ASSERT_TRUE(points.update(state));
    const auto position = onHost(points.position);
    const auto size = onHost(points.size);
    const auto before = onHost(points.before);
    const auto after = onHost(points.after);
    const auto apart = [&](int o, int k)
    { return std::hypot(oldPosition(o, 0) - position(k, 0), oldPosition(o, 1) - position(k, 1)); };
    for (int k = 0; k < points.count(); ++k)
    {
      ASSERT_GE(before(k), 0);
      EXPECT_LE(apart(before(k), k), 0.5 * std::max(oldSize(before(k)), size(k)) * (1.0 + 1e-9));
    }
    for (int o = 0; o < old; ++o)
    {
      ASSERT_GE(after(o), 0);
      EXPECT_LE(apart(o, after(o)), 0.5 * std::max(oldSize(o), size(after(o))) * (1.0 + 1e-9));
    }
  };
  const int few = points.count();
  check(fine->state());
  EXPECT_GT(points.count(), 2 * few);
  check(coarse->state());
  EXPECT_EQ(points.count(), few);
}
