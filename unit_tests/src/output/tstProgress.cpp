#include "output/Progress.hpp"

#include <gtest/gtest.h>

#include <cmath>
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
      progress.sample(0.0, {{"kinetic", 1.0}, {"Notch.0.G_J", 12.5}, {"Notch.1.G_J", 7.0}});
    progress.step(0.02 * step, step);
  }
  progress.finish();
  EXPECT_EQ(out.str(), " 10 %, 9 s left, step 10\n"
                       " 20 %, 8 s left, step 20, G 12.5, 7 J/m2\n"
                       " 30 %, 7 s left, step 30, G 12.5, 7 J/m2\n"
                       " 40 %, 6 s left, step 40, G 12.5, 7 J/m2\n"
                       " 50 %, 5 s left, step 50, G 12.5, 7 J/m2\n"
                       " 60 %, 4 s left, step 60, G 12.5, 7 J/m2\n"
                       " 70 %, 3 s left, step 70, G 12.5, 7 J/m2\n"
                       " 80 %, 2 s left, step 80, G 12.5, 7 J/m2\n"
                       " 90 %, 1 s left, step 90, G 12.5, 7 J/m2\n"
                       "100 %, step 100, G 12.5, 7 J/m2\n");
}

/// G of each front, of more than four the largest, over the toughness where there is one, and the residual
/// over the largest energy.
TEST(Progress, ShowsReleasesAndTheResidual)
{
  std::ostringstream out;
  Hand hand;
  Progress progress(&out, 2.0, false, hand.clock());
  const Progress::Row row = {{"external_work", 4.0}, {"residual", -0.01}, {"A.0.G_J", 6.0}, {"B.0.G_J", 8.0}};
  progress.sample(1.0, row);
  hand.now += 1.0;
  progress.step(1.0, 1);
  progress.setToughness(10.0);
  progress.sample(1.5,
                  {{"A.0.G_J", 1.0}, {"A.1.G_J", 2.0}, {"B.0.G_J", 9.0}, {"C.0.G_J", 4.0}, {"D.0.G_J", 5.0}});
  progress.step(2.0, 2);
  EXPECT_EQ(out.str(), " 50 %, 1 s left, step 1, G 6, 8 J/m2, residual 0.25 %\n"
                       "100 %, step 2, G/Gc 0.9 at most of 5 fronts\n");
}

/// Without a stream nothing is printed; what the line would say is known on request only.
TEST(Progress, IsFollowedWithoutAStream)
{
  Hand hand;
  Progress progress(nullptr, 2.0, false, hand.clock()), followed(nullptr, 2.0, false, hand.clock());
  followed.follow();
  hand.now += 1.0;
  progress.step(1.0, 1);
  followed.step(1.0, 1);
  EXPECT_EQ(progress.done(), 0.0);
  EXPECT_EQ(followed.done(), 0.5);
  EXPECT_EQ(followed.text(), " 50 %, 1 s left, step 1");
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

/// A long load step: nothing in its first two seconds, then a line every two seconds.
TEST(Progress, SaysHowFarALoadStepIs)
{
  std::ostringstream out;
  Hand hand;
  Progress progress(&out, 1.0, true, hand.clock());
  for (int k = 0; k < 5; ++k)
  {
    progress.iteration(3, k, std::pow(0.1, k));
    hand.now += 1.5;
  }
  progress.step(1.0, 3);
  progress.finish();
  EXPECT_EQ(out.str(),
            "\rload step 3: iteration 3, residual 1.0e-02\rload step 3: iteration 5, residual 1.0e-04"
            "\r100 %, step 3" +
                std::string(29, ' ') + "\n");
}

/// Of a run with one load step nothing is said of its number.
TEST(Progress, NamesNoLoadStepWhereThereIsOne)
{
  std::ostringstream out;
  Hand hand;
  Progress progress(&out, 1.0, true, hand.clock());
  hand.now += 3.0;
  progress.iteration(0, 4, 1e-4);
  EXPECT_EQ(out.str(), "\riteration 5, residual 1.0e-04");
}

/// Lengths of cracks in 2D and areas in 3D, where they are asked for; the length of a front in 3D is none.
TEST(Progress, ShowsHowFarCracksHaveCome)
{
  std::ostringstream out;
  Progress progress(&out, 2.0, false);
  const Progress::Row flat = {{"A.0.G_J", 6.0}, {"A.0.length", 0.0125}, {"A.1.length", 0.003}};
  progress.sample(1.0, flat);
  EXPECT_EQ(progress.text(false).find("crack"), std::string::npos);
  progress.showExtents();
  progress.sample(1.0, flat);
  EXPECT_NE(progress.text(false).find(", G 6 J/m2, crack 12.5 mm, 3 mm"), std::string::npos)
      << progress.text(false);
  progress.sample(1.0, {{"A.area", 2.5e-5}, {"A.0.length", 0.0125}});
  EXPECT_NE(progress.text(false).find(", crack area 25 mm2"), std::string::npos) << progress.text(false);
}

/// A run that is not watched says after two seconds how long it takes, not only after a tenth of its time.
TEST(Progress, SaysEarlyHowLongItTakes)
{
  std::ostringstream out;
  Hand hand;
  Progress progress(&out, 1000.0, false, hand.clock());
  for (int step = 1; step <= 30; ++step)
  {
    hand.now += 0.125;
    progress.step(0.1 * step, step);
  }
  EXPECT_EQ(out.str(), "  0 %, 20 min 48 s left, step 16\n");
}

/// Time left is by the pace of late: 40 s at 1 s a second and then 10 s at a tenth of it leave 59 / 0.1 s.
TEST(Progress, GoesByThePaceOfLate)
{
  std::ostringstream out;
  Hand hand;
  Progress progress(&out, 100.0, true, hand.clock());
  double time = 0.0;
  for (int step = 1; step <= 400; ++step)
  {
    hand.now += 0.1;
    progress.step(time += 0.1, step);
  }
  for (int step = 401; step <= 1000; ++step)
  {
    hand.now += 0.1;
    progress.step(time += 0.01, step);
  }
  const std::string text = out.str();
  EXPECT_EQ(text.substr(text.rfind('\r')), "\r 45 %, 9 min 01 s left, step 999");
}

/// Kinetic over strain energy falls as exp(-t) to 1e-6 at 13.8 s, and so does G - 1, as exp(-t/2), to 1e-3.
/// At 2.1 s that is told to 13 s, for what counts is the largest value of the last quarter.
TEST(Progress, SaysWhenTheRunIsAtRest)
{
  std::ostringstream out;
  Hand hand;
  Progress progress(&out, 1000.0, false, hand.clock());
  progress.stopsAtRest(1e-6, 1e-3);
  for (int step = 1; step <= 21; ++step)
  {
    hand.now += 0.1;
    const double t = 0.1 * step;
    progress.sample(t,
                    {{"kinetic", std::exp(-t)}, {"strain", 1.0}, {"Notch.0.G_J", 1.0 + std::exp(-t / 2.0)}});
    progress.step(t, step);
  }
  EXPECT_EQ(out.str(), "  0 %, about 13 s to rest, step 21, G 1.3499 J/m2\n");
}

/// Before there are enough samples only the final time is known.
TEST(Progress, SaysHowLongARunThatSettlesTakesAtMost)
{
  std::ostringstream out;
  Hand hand;
  Progress progress(&out, 4.0, false, hand.clock());
  progress.stopsAtRest(1e-6, 1e-3);
  hand.now += 1.0;
  progress.sample(1.0, {{"kinetic", 1.0}, {"strain", 1.0}});
  progress.step(1.0, 1);
  EXPECT_EQ(out.str(), " 25 %, at most 3 s left, step 1\n");
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
  progress.sample(0.0, {{"a.0.G_J", 1.0}});
  progress.step(1.0, 1);
  progress.finish();
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}
