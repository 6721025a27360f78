/// Loops over few items visit each of them once, however many there are.

#include "state/FewItems.hpp"

#include <gtest/gtest.h>

namespace Rhegma
{
namespace Test
{

namespace
{

/// Sum of the numbers of visits times the item's number, by the one loop and the other.
void visitAll(int count)
{
  const View<int*> visits("visits", count);
  forFew(
      "visit", count, KOKKOS_LAMBDA(const int k) { visits(k) += 1; });
  const long sum = sumFew<long>(
      "sum", count, KOKKOS_LAMBDA(const int k, long& total) { total += static_cast<long>(visits(k)) * k; });
  EXPECT_EQ(sum, static_cast<long>(count) * (count - 1) / 2);
}

} // namespace

TEST(FewItems, EachOnceWhereOneThreadDoesThem)
{
  visitAll(0);
  visitAll(1);
  visitAll(fewItems);
}

TEST(FewItems, EachOnceWhereThereAreMore)
{
  visitAll(fewItems + 1);
  visitAll(100 * fewItems);
}

} // namespace Test
} // namespace Rhegma
