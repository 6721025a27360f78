#include "grid/KeyNumbers.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>

using namespace Rhegma;

namespace
{

constexpr unsigned seed = 20261128;

/// Keys of cells in a plane, packed as those of refined cells: many agree in most of their bits.
std::uint64_t keyOfCell(std::mt19937& random)
{
  std::uniform_int_distribution<std::uint64_t> coordinate(0, 60);
  const std::uint64_t x = coordinate(random);
  return x << 21 | coordinate(random);
}

} // namespace

TEST(KeyNumbers, NumbersKeysAsTheyCome)
{
  std::mt19937 random(seed);
  std::map<std::uint64_t, int> expected;
  KeyNumbers numbers;
  EXPECT_EQ(numbers.find(0), -1);
  for (int i = 0; i < 5000; ++i)
  {
    const std::uint64_t key = keyOfCell(random);
    const auto entry = expected.insert({key, static_cast<int>(expected.size())}).first;
    EXPECT_EQ(numbers.add(key), entry->second) << "seed " << seed;
  }
  ASSERT_EQ(numbers.size(), static_cast<int>(expected.size()));
  for (const auto& [key, number] : expected)
  {
    EXPECT_EQ(numbers.find(key), number);
    EXPECT_EQ(numbers.keys()[number], key);
  }
  for (std::uint64_t x = 0; x < 70; ++x)
    for (std::uint64_t y = 0; y < 70; ++y)
      EXPECT_EQ(numbers.find(x << 21 | y) >= 0, expected.count(x << 21 | y) > 0);
}

TEST(KeyNumbers, ComparesKeysInAnyOrder)
{
  KeyNumbers a, b;
  for (std::uint64_t key = 0; key < 200; ++key)
  {
    a.add(key * key);
    b.add((199 - key) * (199 - key));
  }
  EXPECT_TRUE(a.sameKeys(b));
  b.add(1ULL << 62);
  EXPECT_FALSE(a.sameKeys(b));
  a.add((1ULL << 62) + 1);
  EXPECT_FALSE(a.sameKeys(b));
}
