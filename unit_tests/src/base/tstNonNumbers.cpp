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
  EXPECT_EQ(withWordsForNonNumbers("it is -inf. A crack is nan."),
            "it is endlessly many. A crack is no number of.");
  EXPECT_EQ(withWordsForNonNumbers(""), "");
  EXPECT_EQ(withWordsForNonNumbers("in"), "in");
}

TEST(NonNumbers, AreNoNamesOrQuotations)
{
  for (const char* right :
       {"Bodies > inf: it is thin", "Cracks > nan > Points: it is short",
        "Domain > Upper Corner: \"{nan, 0.09}\" is not finite", "infinite nanny, info_nan2",
        "crack inf, front 0: not initiated",
        "body nan of Materials > Finance: flow_inf, inf_low and nan_tube",
        "crack inflow, front 0: the pieces far-inf, inf-far, x.nan and nan.x", "w\xC3\xA4nan"})
  {
    EXPECT_EQ(findNonNumber(right), std::string::npos) << right;
    EXPECT_EQ(withWordsForNonNumbers(right), right);
  }
  EXPECT_EQ(findNonNumber("\"inf\" is inf"), 9u);
  EXPECT_EQ(findNonNumber("inf", 1), std::string::npos);
}

} // namespace Test
} // namespace Rhegma
