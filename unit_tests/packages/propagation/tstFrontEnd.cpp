// What became of a front, on hand-made histories.

#include "propagation/FrontEnd.hpp"

#include <gtest/gtest.h>

#include <string>

using namespace Rhegma;
using namespace Rhegma::propagation;

namespace
{

/// Toughness 10 J/m2 while it runs, 30 to initiate, 2 to be arrested.
Options optionsOf() { return {{Toughness::parse("10"), 30.0, 2.0}, {}, 1.0, 0.0, 0.0, {}}; }

/// A front of some nodes that each made ten increments of 1 mm in 10 us, the last at 100 us, and have had G =
/// 9 J/m2 since then, up to the time of the clock.
template <int D>
struct Paused
{
  State<D> state;
  CrackFront<D> front;
  FrontState<D> own;

  Paused(int nodes, double now)
  {
    constexpr double fastest = 100.0; // its increments take 10 us at least
    const AdvanceRule rule = ruleAt(0.0, optionsOf());
    state.materials.properties.resize(1);
    state.clock.time = now;
    front.nodes.clear();
    for (int k = 0; k < nodes; ++k)
    {
      FrontNode<D> node;
      node.name = k;
      node.driving.release = 9.0;
      front.nodes.push_back(node);
      FrontNodeState& past = own.nodes[k];
      past.speedLimit = fastest;
      past.increment = 1e-3;
      double time = 0.0;
      while (past.history.increments() < 10)
        own.count(past.history, past.history.advance(rule, time += 1e-6, 100.0, 1e-3, fastest).increments);
      while ((time += 1e-6) <= now)
        past.history.advance(rule, time, 9.0, 1e-3, fastest);
    }
  }

  FrontEnd<D> end() const { return {state, optionsOf(), front, own}; }
};

template <class Case>
std::string textOf(const Case& one)
{
  return fateAsText(one.front, one.own, one.end());
}

} // namespace

/// Ten increments take 90 us, so that 30 us after the last one the front pauses; its speed is then below a
/// fiftieth of 100 m/s after 1 mm / (2 m/s) = 500 us. What it needs is the toughness of a running front.
TEST(FrontEnd, APauseIsNeitherARunNorArrest)
{
  const Paused<2> soon(1, 120e-6), later(1, 200e-6), long_(1, 700e-6);
  EXPECT_FALSE(soon.end().pauses);
  EXPECT_EQ(statusOf(soon.front, soon.end()), "running");
  EXPECT_TRUE(later.end().pauses);
  EXPECT_FALSE(later.end().waits);
  EXPECT_EQ(statusOf(later.front, later.end()), "pausing");
  EXPECT_EQ(later.end().toughness, 10.0);
  EXPECT_NE(textOf(later).find("G = 9 J/m2 below Gc = 10 J/m2, but too short ago"), std::string::npos)
      << textOf(later);
  EXPECT_TRUE(long_.end().waits);
  EXPECT_EQ(statusOf(long_.front, long_.end()), "pausing");
  EXPECT_NE(textOf(long_).find("but not below Arrest Toughness = 2 J/m2: it does not advance unless G rises"),
            std::string::npos)
      << textOf(long_);
}

/// A front of many nodes pauses like one of a single node.
TEST(FrontEnd, FrontsOfManyNodesPauseLikeOthers)
{
  const Paused<3> soon(4, 120e-6), later(4, 200e-6), long_(4, 700e-6);
  EXPECT_EQ(statusOf(soon.front, soon.end()), "running");
  EXPECT_EQ(statusOf(later.front, later.end()), "pausing");
  EXPECT_FALSE(later.end().waits);
  EXPECT_TRUE(long_.end().waits);
}

/// G of a front since its last advance, in the mean: 9 J/m2 after samples of 100 J/m2 up to the advance,
/// which lies between two samples 1 us apart.
TEST(FrontEnd, TheMeanOfGSinceTheLastAdvanceIsKnown)
{
  const Paused<2> one(1, 700e-6);
  EXPECT_NEAR(one.own.nodes.at(0).history.meanSinceAdvance(), 9.0, 100.0 * 2e-6 / 600e-6);
  EXPECT_EQ(FrontHistory().meanSinceAdvance(), 0.0);
}

/// No crack has a negative G: a front that pauses with one is not said to be about to arrest.
TEST(FrontEnd, ANegativeReleaseIsNotTrusted)
{
  Paused<2> one(1, 200e-6);
  one.front.nodes[0].driving.release = -5.0;
  EXPECT_NE(textOf(one).find("which is negative: its J integral can't be relied on"), std::string::npos)
      << textOf(one);
}

/// Without a contour G is not known, and nothing says that it was.
TEST(FrontEnd, AStopWithoutContourHasNoG)
{
  Paused<2> one(1, 120e-6);
  one.front.nodes[0].stopped = true;
  one.front.stop = {"with no material left in the domain", 1e-4, {}, 9.0, 10.0, true};
  EXPECT_NE(textOf(one).find("G is not known, it was last 9 J/m2 for Gc = 10 J/m2"), std::string::npos)
      << textOf(one);
  one.front.stop.lost = false;
  EXPECT_NE(textOf(one).find("(a numerical stop, not arrest): G = 9 J/m2 for Gc"), std::string::npos);
}

/// Nodes that hardly moved have no settled speed and do not lower that of the others.
TEST(FrontState, TheSettledSpeedIsThatOfNodesThatRan)
{
  Paused<3> one(2, 120e-6);
  const double speed = one.own.settledSpeed();
  EXPECT_NEAR(speed, 100.0, 1e-6);
  one.own.nodes[2] = FrontNodeState();
  EXPECT_EQ(one.own.settledSpeed(), speed);
}
