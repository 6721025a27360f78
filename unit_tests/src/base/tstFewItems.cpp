/// Loops over few items visit each of them once, however many there are.

#include "base/SmallLoops.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace Rhegma
{
namespace Test
{

namespace
{

/// Visits of each item by the loop that writes.
std::vector<int> visitsOf(int count)
{
  const View<int*> visits("visits", count);
  parallelForSmall(
      "visit", count, KOKKOS_LAMBDA(const int k) { visits(k) += 1; });
  const auto host = onHost(visits);
  return {host.data(), host.data() + count};
}

/// Sum of 1 + k^2 over the items by the loop that adds: it distinguishes items that are skipped from items
/// that are counted twice.
long sumOf(int count)
{
  return parallelSumSmall<long>(
      "sum", count, KOKKOS_LAMBDA(const int k, long& total) { total += 1 + static_cast<long>(k) * k; });
}

long closedForm(long n) { return n + (n - 1) * n * (2 * n - 1) / 6; }

} // namespace

TEST(FewItems, EachOnceWhereOneThreadDoesThem)
{
  for (const int count : {0, 1, isSmallLoop})
  {
    EXPECT_EQ(visitsOf(count), std::vector<int>(count, 1));
    EXPECT_EQ(sumOf(count), closedForm(count));
  }
}

TEST(FewItems, EachOnceWhereThereAreMore)
{
  for (const int count : {isSmallLoop + 1, 100 * isSmallLoop})
  {
    EXPECT_EQ(visitsOf(count), std::vector<int>(count, 1));
    EXPECT_EQ(sumOf(count), closedForm(count));
  }
}

} // namespace Test
} // namespace Rhegma
