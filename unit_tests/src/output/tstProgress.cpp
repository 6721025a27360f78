#include "output/Progress.hpp"

#include <gtest/gtest.h>

#include <sstream>

using Rhegma::Progress;

namespace
{

/// A clock that a test sets.
struct Hand
{
  double now = 100.0;
  Progress::Clock clock()
  {
    return [this] { return now; };
  }
};

} // namespace

/// A line each tenth; after 1 s of a run at even pace 9 s are left.
TEST(Progress, PlainLinesEachTenth)
{
  std::ostringstream out;
  Hand hand;
  Progress progress(&out, 2.0, false, hand.clock());
  for (int step = 1; step <= 100; ++step)
  {
    hand.now += 0.1;
    if (step == 15)
      progress.sample({{"kinetic", 1.0}, {"Notch.0.G_J", 12.5}, {"Notch.1.G_J", 7.0}});
    progress.step(0.02 * step, step);
  }
  progress.finish();
  EXPECT_EQ(out.str(), " 10 %, 9 s left, step 10\n"
                       " 20 %, 8 s left, step 20, G 12.5 J/m2\n"
                       " 30 %, 7 s left, step 30, G 12.5 J/m2\n"
                       " 40 %, 6 s left, step 40, G 12.5 J/m2\n"
                       " 50 %, 5 s left, step 50, G 12.5 J/m2\n"
                       " 60 %, 4 s left, step 60, G 12.5 J/m2\n"
                       " 70 %, 3 s left, step 70, G 12.5 J/m2\n"
                       " 80 %, 2 s left, step 80, G 12.5 J/m2\n"
                       " 90 %, 1 s left, step 90, G 12.5 J/m2\n"
                       "100 %, step 100, G 12.5 J/m2\n");
}

TEST(Progress, OneLineOnATerminal)
{
  std::ostringstream out;
  Hand hand;
  Progress progress(&out, 1000.0, true, hand.clock());
  hand.now += 1.0;
  progress.step(0.1, 1); // 9999 s left
  hand.now += 0.1;
  progress.step(0.2, 2); // too soon after the last
  hand.now += 0.9;
  progress.step(500.0, 3);
  hand.now += 0.1;
  progress.step(1000.0, 4);
  progress.finish();
  // Blanks wipe out what a longer line left: 7 and 10 characters.
  EXPECT_EQ(out.str(), "\r  0 %, 2 h 46 min left, step 1\r 50 %, 2 s left, step 3" + std::string(7, ' ') +
                           "\r100 %, step 4" + std::string(10, ' ') + "\n");
}

/// A run continued at 50 of 100 s that does 10 s of them in 1 s has 4 s left.
TEST(Progress, CountsAContinuedRunFromWhereItBegan)
{
  std::ostringstream out;
  Hand hand;
  Progress progress(&out, 100.0, false, hand.clock());
  progress.step(50.0, 1000);
  hand.now += 1.0;
  progress.step(60.0, 1200);
  EXPECT_EQ(out.str(), " 60 %, 4 s left, step 1200\n");
}

TEST(Progress, ARunThatStopsEarlySaysWhere)
{
  std::ostringstream out;
  Hand hand;
  Progress progress(&out, 1.0, false, hand.clock());
  hand.now += 1.0;
  progress.step(0.05, 1);
  progress.finish();
  EXPECT_EQ(out.str(), "  5 %, step 1\n");
}

TEST(Progress, IsQuietWithoutAStream)
{
  testing::internal::CaptureStdout();
  Progress progress(nullptr, 1.0, true);
  progress.sample({{"a.0.G_J", 1.0}});
  progress.step(1.0, 1);
  progress.finish();
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}
