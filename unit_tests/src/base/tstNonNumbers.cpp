/// Words in place of numbers that are none.

#include "base/NonNumbers.hpp"

#include <gtest/gtest.h>

namespace Rhegma
{
namespace Test
{

TEST(NonNumbers, AreReplacedByWords)
{
  EXPECT_EQ(withWordsForNonNumbers("Cracks > Notch > Points: the crack is inf cells long"),
            "Cracks > Notch > Points: the crack is endlessly many cells long");
  EXPECT_EQ(withWordsForNonNumbers("inf, -inf and (-nan K)"),
            "endlessly many, endlessly many and (no number of K)");
  EXPECT_EQ(withWordsForNonNumbers(""), "");
  EXPECT_EQ(withWordsForNonNumbers("in"), "in");
}

TEST(NonNumbers, AreNoNamesOrQuotations)
{
  for (const char* right :
       {"Bodies > inf: it is thin", "Cracks > nan > Points: it is short",
        "Domain > Upper Corner: \"{nan, 0.09}\" is not finite", "infinite nanny, info_nan2"})
  {
    EXPECT_EQ(findNonNumber(right), std::string::npos) << right;
    EXPECT_EQ(withWordsForNonNumbers(right), right);
  }
  EXPECT_EQ(findNonNumber("\"inf\" is inf"), 9u);
  EXPECT_EQ(findNonNumber("inf", 1), std::string::npos);
}

} // namespace Test
} // namespace Rhegma
