#include "base/Numbers.hpp"

#include <gtest/gtest.h>

#include <limits>

using namespace Rhegma;

TEST(ReadableNumbers, ChooseThePrefixOfTheUnit)
{
  EXPECT_EQ(readableTime(4.736e-4), "473.6 us");
  EXPECT_EQ(readableTime(2.0), "2 s");
  EXPECT_EQ(readableTime(3600.0), "3600 s");
  EXPECT_EQ(readableTime(1.41e-7), "141 ns");
  EXPECT_EQ(readableLength(0.00125), "1.25 mm");
  EXPECT_EQ(readableLength(-0.05), "-50 mm");
  EXPECT_EQ(readableEnergy(0.0703), "70.3 mJ");
  EXPECT_EQ(readableEnergy(12500.0), "12.5 kJ");
}

TEST(ReadableNumbers, ChoosesAfterRounding) { EXPECT_EQ(readableLength(0.99999e-3), "1 mm"); }

TEST(ReadableNumbers, WithoutPrefixWhereNoneFits)
{
  EXPECT_EQ(readableTime(0.0), "0 s");
  EXPECT_EQ(readableTime(1e-30), "1e-30 s");
  EXPECT_EQ(readableTime(std::numeric_limits<double>::infinity()), "inf s");
}
