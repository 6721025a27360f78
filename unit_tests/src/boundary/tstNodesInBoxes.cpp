/// Which of many positions lie in boxes: by a tree as by a look at all.

#include "boundary/NodesInBoxes.hpp"

#include <gtest/gtest.h>

#include <iostream>
#include <random>

namespace Rhegma
{
namespace Test
{

TEST(NodesInBoxes, AreThoseOfALookAtAll)
{
  const unsigned seed = std::random_device()();
  std::cout << "seed " << seed << "\n";
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> node(0, 12); // boxes end at nodes, too
  std::vector<Vector<2>> positions;
  for (int k = 0; k < 300; ++k)
    positions.push_back({{0.25 * node(random), 0.25 * node(random)}});
  const NodesInBoxes<2> all(positions, 1), tree(positions, 1000);
  for (int k = 0; k < 200; ++k)
  {
    Geometry::Bounds<2> box = Geometry::emptyBounds<2>();
    for (int corner = 0; corner < 2; ++corner)
      box.include(Vector<2>{{0.25 * node(random), 0.25 * node(random)}});
    for (const bool outside : {false, true})
    {
      int expected = 0, found = 0;
      Vector<2> sum{}, sumExpected{};
      all.visit(box, outside,
                [&](const Vector<2>& x)
                {
                  ++expected;
                  sumExpected = sumExpected + x;
                });
      tree.visit(box, outside,
                 [&](const Vector<2>& x)
                 {
                   ++found;
                   sum = sum + x;
                 });
      EXPECT_EQ(found, expected);
      EXPECT_EQ(sum[0], sumExpected[0]);
      EXPECT_EQ(sum[1], sumExpected[1]);
    }
  }
}

} // namespace Test
} // namespace Rhegma
