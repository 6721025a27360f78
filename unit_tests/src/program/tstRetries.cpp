/// Whether a failed run goes back and uses shorter steps.

#include "program/Retries.hpp"

#include <gtest/gtest.h>

namespace Rhegma
{
namespace program
{

TEST(Retries, GoesBackAsOftenAsAllowed)
{
  Retries retries(2);
  EXPECT_TRUE(retries.mayHelp("one", 0.0, 1.0));
  EXPECT_TRUE(retries.mayHelp("two", 1.0, 3.0));
  EXPECT_FALSE(retries.mayHelp("three", 3.0, 9.0));
  EXPECT_FALSE(Retries(0).mayHelp("one", 0.0, 1.0));
}

TEST(Retries, StopsWhereShorterStepsChangeNothingTwice)
{
  // The same time means within 1 % of the time since the state in memory, here 1 ms.
  Retries retries(10);
  EXPECT_TRUE(retries.mayHelp("out of the domain", 0.9, 1.0));
  EXPECT_TRUE(retries.mayHelp("out of the domain", 0.9, 1.0005));
  EXPECT_FALSE(retries.mayHelp("out of the domain", 0.9, 1.0008));
}

TEST(Retries, CountsAnewWhereTheTimeMoves)
{
  Retries retries(10);
  EXPECT_TRUE(retries.mayHelp("impact", 0.9, 1.0));
  EXPECT_TRUE(retries.mayHelp("impact", 0.9, 1.0));
  // Twice as far as a hundredth: the second attempt got further.
  retries = Retries(10);
  EXPECT_TRUE(retries.mayHelp("impact", 0.9, 1.0));
  EXPECT_TRUE(retries.mayHelp("impact", 0.9, 1.002));
  EXPECT_TRUE(retries.mayHelp("impact", 0.9, 1.004));
  EXPECT_TRUE(retries.mayHelp("impact", 0.9, 1.006));
}

TEST(Retries, SaysWhatItDid)
{
  Retries retries(3);
  EXPECT_EQ(retries.inVain(), "");
  retries.mayHelp("a particle is inverted", 0.25, 0.5);
  retries.setStepFraction(0.5);
  EXPECT_NE(retries.asText().find("a particle is inverted; "), std::string::npos);
  EXPECT_NE(retries.asText().find("250 ms"), std::string::npos);
  EXPECT_EQ(retries.inVain().rfind("; time steps of 0.5 of the stable length", 0), 0u) << retries.inVain();
}

} // namespace program
} // namespace Rhegma
