/// When and where fronts advance, without a body.

#include "Pi.hpp"
#include "material/MaterialTable.hpp"
#include "material/RayleighSpeed.hpp"
#include "propagation/Aim.hpp"
#include "propagation/Direction.hpp"
#include "propagation/FrontHistory.hpp"
#include "propagation/Options.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace Rhegma;
using namespace Rhegma::propagation;

namespace
{

using Rhegma::Test::pi;
const double degree = pi / 180.0;

double speedOf(Plane plane, double poisson)
{
  Teuchos::ParameterList list;
  list.set("Model", "Linear Elastic");
  list.set("Density", 1200.0);
  list.set("Young Modulus", 3e9);
  list.set("Poisson Ratio", poisson);
  return rayleighSpeed(makeProperties(list, "Polymer", plane));
}

AdvanceRule ruleOf(const std::string& toughness, double atRest)
{
  return {Toughness::parse(toughness), atRest, atRest, 0.0};
}

/// Lets a front run under a constant energy release rate. \return its mean speed after 50 increments
double runAt(double release, const AdvanceRule& rule, double dt, double fastest)
{
  const double increment = 1e-3;
  FrontHistory history;
  double time = 0.0;
  while (history.increments() < 100)
  {
    time += dt;
    history.advance(rule, time, release, increment, fastest);
  }
  return history.settledSpeed();
}

} // namespace

/// Roots of the Rayleigh equation found by Brent's method elsewhere.
TEST(RayleighSpeed, AgreesWithIndependentRoots)
{
  EXPECT_NEAR(speedOf(Plane::Stress, 0.33), 891.0, 0.05);
  EXPECT_NEAR(speedOf(Plane::Strain, 0.33), 903.6, 0.05);
}

/// With Gc = G0 (1 + v / v0) the speed is v0 (G / G0 - 1), whatever the step: releases lie between steps.
TEST(FrontHistory, SpeedIsWhereToughnessIsTheRelease)
{
  const AdvanceRule rule = ruleOf("100*(1 + v/500)", 100.0);
  for (const double dt : {1e-7, 4.3e-7, 1e-6})
    EXPECT_NEAR(runAt(180.0, rule, dt, 1000.0), 400.0, 1e-6 * 400.0) << dt;
}

TEST(FrontHistory, NeverPassesTheFastestSpeed)
{
  EXPECT_NEAR(runAt(180.0, ruleOf("100", 100.0), 3e-7, 900.0), 900.0, 1e-6 * 900.0);
}

TEST(FrontHistory, StartsAtInitiationAndArrestsWhereItHasAlmostStopped)
{
  const AdvanceRule rule{Toughness::parse("159.9*(1 + v/500)"), 150.0, 90.0, 1e-5};
  FrontHistory history;
  const double increment = 1e-3, fastest = 900.0;
  EXPECT_EQ(history.advance(rule, 5e-6, 200.0, increment, fastest).increments, 0) << "before Start Time";
  EXPECT_EQ(history.advance(rule, 2e-5, 140.0, increment, fastest).increments, 0) << "below initiation";
  EXPECT_EQ(history.advance(rule, 3e-5, 160.0, increment, fastest).increments, 1);
  // Half way between the two: where 150 is passed.
  EXPECT_NEAR(history.lastTime(), 2.5e-5, 1e-12);
  EXPECT_TRUE(history.running());
  // 1 mm at no less than 2 % of the fastest speed takes 56 us.
  history.advance(rule, 5e-5, 80.0, increment, fastest);
  EXPECT_TRUE(history.running());
  history.advance(rule, 9e-5, 80.0, increment, fastest);
  EXPECT_FALSE(history.running());
  EXPECT_EQ(history.advance(rule, 1e-4, 140.0, increment, fastest).increments, 0) << "below initiation again";
  EXPECT_EQ(history.increments(), 1);
}

/// A front that rests and is initiated anew: its means are over the longer run, and do not count the rest.
TEST(FrontHistory, SeparatesItsRuns)
{
  const AdvanceRule rule = ruleOf("100*(1 + v/500)", 100.0);
  FrontHistory history;
  const double dt = 1e-6, increment = 1e-3, fastest = 900.0;
  double time = 0.0;
  const auto pull = [&](double release, int steps)
  {
    for (int k = 0; k < steps; ++k)
      history.advance(rule, time += dt, release, increment, fastest);
  };
  pull(180.0, 40); // at 400 m/s, 1 mm takes 2.5 us
  pull(0.0, 200);
  pull(140.0, 16); // at 200 m/s, 5 us
  const std::vector<CrackRun> runs = history.runs();
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_NEAR(runs[0].lastAdvance - runs[0].initiation, (runs[0].length / increment - 1.0) * 2.5e-6, 1e-9);
  EXPECT_GT(runs[0].length, 15.5e-3);
  EXPECT_NEAR(runs[1].initiation, 240e-6, 1.001 * dt);
  EXPECT_NEAR(runs[1].length, 4e-3, 1e-9);
  EXPECT_NEAR(history.settledSpeed(), 400.0, 1e-6 * 400.0);
  EXPECT_NEAR(history.settledRelease(), 180.0, 1e-6 * 180.0);
  EXPECT_LE(history.settled().second, runs[0].lastAdvance);
}

/// The mean of the answer is that of the positions over all the time in which the front ran: here two runs
/// with a rest between them, and one of a single increment, which has no speed.
TEST(FrontHistory, MeanSpeedIsThatOfAllRuns)
{
  const AdvanceRule rule = ruleOf("100*(1 + v/500)", 100.0);
  FrontHistory history;
  const double dt = 1e-7, increment = 1e-3, fastest = 900.0;
  double time = 0.0, position = 0.0;
  std::vector<std::vector<std::pair<double, double>>> runs; // time and position of each increment
  const auto pull = [&](double release, int steps)
  {
    for (int k = 0; k < steps; ++k)
    {
      const bool before = history.running();
      const Advance made = history.advance(rule, time += dt, release, increment, fastest);
      position += increment * made.increments;
      if (made.increments > 0 && !before)
        runs.emplace_back();
      if (made.increments > 0)
        runs.back().emplace_back(history.lastTime(), position);
    }
  };
  pull(180.0, 300); // at 400 m/s
  EXPECT_NEAR(history.meanSpeed(), 400.0, 1e-6 * 400.0);
  pull(0.0, 2000);
  pull(120.0, 500); // at 100 m/s
  pull(0.0, 6000);
  pull(100.0, 1); // one increment
  pull(0.0, 2000);
  ASSERT_EQ(runs.size(), 3U);
  EXPECT_EQ(runs[2].size(), 1U);
  double length = 0.0, duration = 0.0;
  for (const auto& run : runs)
  {
    length += run.back().second - run.front().second;
    duration += run.back().first - run.front().first;
  }
  EXPECT_NEAR(history.meanSpeed(), length / duration, 1e-9 * length / duration);
  // Neither that of the first run, nor that of the second half of the longest one.
  EXPECT_LT(history.meanSpeed(), 250.0);
  EXPECT_GT(history.meanSpeed(), 150.0);
  EXPECT_NEAR(history.settledSpeed(), 400.0, 1e-6 * 400.0);
  EXPECT_EQ(FrontHistory().meanSpeed(), 0.0);
}

/// Long steps hold several increments.
/// Increments in equilibrium, an hour apart, have no speed: that of the motion which follows is its own.
TEST(FrontHistory, MotionBeginsARunOfItsOwn)
{
  constexpr double hour = 3600.0, increment = 1e-3, fastest = 1000.0, dt = increment / fastest;
  const AdvanceRule rule = ruleOf("100", 100.0);
  FrontHistory history;
  history.recordAtRest(rule, hour, 99.0);
  history.advanceInEquilibrium(hour, 100.0, increment);
  history.advanceInEquilibrium(2.0 * hour, 100.0, increment);
  history.startMotion();
  EXPECT_TRUE(history.running());
  EXPECT_TRUE(history.runs().empty());
  EXPECT_EQ(history.meanSpeed(), 0.0);
  for (int k = 1; k <= 20; ++k)
    history.advance(rule, 2.0 * hour + k * dt, 200.0, increment, fastest);
  ASSERT_EQ(history.runs().size(), 1U);
  EXPECT_GE(history.runs()[0].initiation, 2.0 * hour);
  // The time of an increment is one of two hours, to rounding: of 20 steps of a microsecond 1e-6 is left.
  EXPECT_NEAR(history.meanSpeed(), fastest, 1e-5 * fastest);
  EXPECT_EQ(history.increments(), 2 + static_cast<long>(std::lround(history.runs()[0].length / increment)));
}

TEST(FrontHistory, AFrontThatHasNotGrownIsAtRestWhereMotionBegins)
{
  FrontHistory history;
  history.recordAtRest(ruleOf("100", 100.0), 1.0, 99.0);
  history.startMotion();
  EXPECT_FALSE(history.running());
  EXPECT_TRUE(history.runs().empty());
}

TEST(FrontHistory, AdvancesSeveralTimesInALargeStep)
{
  const AdvanceRule rule = ruleOf("100*(1 + v/500)", 100.0);
  FrontHistory history;
  history.advance(rule, 1e-6, 180.0, 1e-3, 900.0);
  history.advance(rule, 2e-6, 180.0, 1e-3, 900.0);
  const Advance made = history.advance(rule, 1.2e-5, 180.0, 1e-3, 900.0);
  EXPECT_EQ(made.increments, 4); // at 400 m/s one takes 2.5 us
  EXPECT_NEAR(made.toughness, 180.0, 1e-6);
}

/// Whether a front would advance is what advance() does, and asking changes nothing.
TEST(FrontHistory, KnowsWhetherItWouldAdvance)
{
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> release(60.0, 260.0), step(2e-7, 2e-6);
  const AdvanceRule rule{Toughness::parse("100*(1 + v/500)"), 120.0, 90.0, 2e-5};
  FrontHistory history;
  double time = 0.0;
  for (int k = 0; k < 2000; ++k)
  {
    time += step(engine);
    const double G = release(engine);
    const bool would = history.wouldAdvance(rule, time, G, 1e-3, 900.0);
    EXPECT_EQ(history.wouldAdvance(rule, time, G, 1e-3, 900.0), would);
    EXPECT_EQ(history.advance(rule, time, G, 1e-3, 900.0).increments > 0, would) << k;
  }
  EXPECT_GT(history.increments(), 100);
}

namespace
{

/// Lets a front run until `end` under a release that changes in time, which is known only when it is due.
/// \param samples out: how often
FrontHistory runSampled(const std::function<double(double)>& release, const AdvanceRule& rule,
                        double interval, double end, int& samples)
{
  const double dt = 2e-7, increment = 1e-3, fastest = 900.0;
  FrontHistory history;
  samples = 0;
  for (int k = 1; k * dt <= end; ++k)
  {
    if (!history.isDue(rule, k * dt, dt, interval, increment, fastest))
      continue;
    history.advance(rule, k * dt, release(k * dt), increment, fastest);
    ++samples;
  }
  return history;
}

} // namespace

/// Where the release is a straight line in time, interpolated and extrapolated crossings are exact, so that a
/// front that is sampled when it is due advances when one does that is sampled in every step.
TEST(FrontHistory, AdvancesAsOftenSampledWhereTheReleaseIsALine)
{
  const AdvanceRule rule = ruleOf("100*(1 + v/500)", 100.0);
  const auto line = [](double t) { return 60.0 + 4e6 * t; };
  int every = 0, due = 0;
  const FrontHistory often = runSampled(line, rule, 0.0, 4e-5, every);
  const FrontHistory seldom = runSampled(line, rule, 1e-6, 4e-5, due);
  ASSERT_EQ(often.increments(), seldom.increments());
  EXPECT_GT(often.increments(), 8);
  EXPECT_NEAR(often.firstTime(), 1e-5, 1e-11);
  EXPECT_NEAR(seldom.firstTime(), often.firstTime(), 1e-11);
  EXPECT_NEAR(seldom.lastTime(), often.lastTime(), 1e-11);
  EXPECT_EQ(every, 200);
  EXPECT_LT(due, 100);
}

/// Of a wave whose period is eight intervals or more, the straight line misses at most (pi / 8)^2 / 2 of its
/// amplitude A, 8 %: the front initiates no later than by the time in which G changes by that, and an
/// interval.
TEST(FrontHistory, InitiatesInTimeWhereTheReleaseIsAWave)
{
  const double interval = 1e-6, period = 8.0 * interval, amplitude = 50.0;
  const AdvanceRule rule = ruleOf("100", 100.0);
  for (const double phase : {0.0, 0.7, 1.4, 2.1, 2.8})
  {
    int samples = 0;
    const auto wave = [&](double t) { return 80.0 + amplitude * std::sin(2.0 * pi * t / period + phase); };
    const double often = runSampled(wave, rule, 0.0, 4.0 * period, samples).firstTime();
    const double seldom = runSampled(wave, rule, interval, 4.0 * period, samples).firstTime();
    EXPECT_NEAR(seldom, often, interval) << phase;
  }
}

/// Pure sliding: the kink of largest energy release is at 75.6 degrees (Hussain, Pu and Underwood 1974
/// have 75.2 to 75.6 from other solutions), and no mode II is no kink.
TEST(Direction, LargestEnergyReleaseOfAKink)
{
  EXPECT_NEAR(energyReleaseAngle(0.0, 1.0), -75.6 * degree, 0.3 * degree);
  EXPECT_NEAR(energyReleaseAngle(0.0, -1.0), 75.6 * degree, 0.3 * degree);
  EXPECT_NEAR(energyReleaseAngle(1.0, 0.0), 0.0, 1e-6);
  // For small sliding every criterion has the angle -2 K_II / K_I.
  EXPECT_NEAR(energyReleaseAngle(1.0, 0.01), -0.02, 2e-4);
}

/// Small turns in pure mode I: G falls by 1 - t^2 / 2 (Cotterell and Rice 1980) and the ratio is quadratic,
/// so that both optima are known. The frame of the front may be turned and mirrored.
TEST(Direction, AimsAtTheLargestReleaseOverTheToughness)
{
  const double strength = 1.3, weak = 2.0 * degree;
  for (const double ahead : {0.0, 40.0 * degree, -130.0 * degree, 179.5 * degree})
    for (const double normal : {1.0, -1.0})
    {
      const ToughnessRatio ratio = ToughnessRatio::parse("1 + 2.6*(1 - cos(a - " + std::to_string(ahead) +
                                                         " - " + std::to_string(normal * weak) + "))");
      const Aim aim = aimOf(3e6, 0.0, ahead, normal, ratio, false);
      const double expected = strength / (strength + 0.5) * weak;
      EXPECT_NEAR(aim.angle, expected, 0.01 * weak);
      EXPECT_NEAR(aim.weight, 1.0 + strength * std::pow(expected - weak, 2), 1e-5);
      EXPECT_NEAR(aim.drive * aim.weight, 1.0 - 0.5 * expected * expected, 1e-5);
      const Aim straight = aimOf(3e6, 0.0, ahead, normal, ratio, true);
      EXPECT_EQ(straight.angle, 0.0);
      EXPECT_NEAR(straight.drive * straight.weight, 1.0, 1e-14);
    }
  // Without preference the direction is that of the largest G alone.
  const ToughnessRatio even = ToughnessRatio::parse("2");
  for (const double sliding : {-0.7, 0.2, 3.0})
  {
    const Aim aim = aimOf(1.0, sliding, 0.3, 1.0, even, false);
    EXPECT_NEAR(aim.angle, energyReleaseAngle(1.0, sliding), 1e-6);
    EXPECT_GT(2.0 * aim.drive, 1.0);
  }
  for (const char* wrong : {"", "b", "cos(a)", "0", "1, 2", "a = 1", "4 - a", "a > 0 ? 1 : 3"})
    EXPECT_THROW(ToughnessRatio::parse(wrong), std::invalid_argument) << wrong;
}

TEST(Direction, TurnsInTheFrameOfTheFront)
{
  CrackFront<2> front;
  front.direction = {{0.0, 1.0}};
  front.normal = {{-1.0, 0.0}};
  front.nodes[0].driving.hoopAngle = -30.0 * degree;
  const auto next = [&](DirectionRule rule)
  { return turned(front.direction, front.normal, turningAngle(front.nodes[0].driving, rule)); };
  const Vector<2> kinked = next(DirectionRule::HoopStress);
  EXPECT_NEAR(kinked[0], 0.5, 1e-12);
  EXPECT_NEAR(kinked[1], std::cos(30.0 * degree), 1e-12);
  const Vector<2> straight = next(DirectionRule::Straight);
  EXPECT_NEAR(straight[1], 1.0, 1e-12);
}

/// J of the three modes in plane strain is the sum of what each releases (Irwin); a mode I that closes is no
/// part of what drives a front, and the others are all of it.
TEST(OpeningRelease, IsWhatOpeningAndSlidingRelease)
{
  const double young = 3e9, poisson = 0.3;
  Teuchos::ParameterList list;
  list.set("Model", "Linear Elastic");
  list.set("Density", 1200.0);
  list.set("Young Modulus", young);
  list.set("Poisson Ratio", poisson);
  const Elasticity e = elasticity(makeProperties(list, "Polymer", Plane::Strain));
  const double opens = 4e5, slides = 3e5, tears = 2e5;
  const double I = opens * opens * (1.0 - poisson * poisson) / young;
  const double II = slides * slides * (1.0 - poisson * poisson) / young;
  const double III = tears * tears * (1.0 + poisson) / young;
  const auto release = [&](double KI, double KII, double KIII, double J)
  {
    DrivingForce driving;
    driving.release = J;
    driving.modeI = KI;
    driving.modeII = KII;
    driving.modeIII = KIII;
    return openingRelease(driving, modeRelease(e));
  };
  EXPECT_DOUBLE_EQ(release(opens, slides, tears, I + II + III), I + II + III);
  EXPECT_NEAR(release(-opens, slides, tears, I + II + III), II + III, 1e-12 * (II + III));
  EXPECT_NEAR(release(-opens, 0.0, tears, I + III), III, 1e-12 * III);
  EXPECT_NEAR(release(-opens, slides, 0.0, I + II), II, 1e-12 * II);
  EXPECT_EQ(release(-opens, 0.0, 0.0, I), 0.0);
  EXPECT_EQ(release(0.0, 0.0, 0.0, I), I); // before intensities are known
}
