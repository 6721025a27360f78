#include "base/Pack.hpp"

#include <gtest/gtest.h>

using namespace Rhegma;

TEST(Pack, ReadsAndWritesAtAnyOffset)
{
  double row[7] = {0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0};
  for (int at = 0; at < 3; ++at)
  {
    const Pack<4> p = Pack<4>::load(row + at);
    for (int k = 0; k < 4; ++k)
      EXPECT_EQ(p[k], at + k);
  }
  (2.0 * Pack<2>::load(row + 5)).store(row + 1);
  EXPECT_EQ(row[0], 0.0);
  EXPECT_EQ(row[1], 10.0);
  EXPECT_EQ(row[2], 12.0);
  EXPECT_EQ(row[3], 3.0);
}

TEST(Pack, AddsMultiples)
{
  Pack<4> sum = Pack<4>::zero();
  sum.add(2.0, pack(1.0, 2.0, 3.0, 4.0));
  sum.add(-1.0, pack(1.0, 1.0, 0.0, 8.0));
  const double wanted[4] = {1.0, 3.0, 6.0, 0.0};
  for (int k = 0; k < 4; ++k)
    EXPECT_EQ(sum[k], wanted[k]);
}
