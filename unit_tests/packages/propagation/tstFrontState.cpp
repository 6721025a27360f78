/// What propagation knows about fronts, on hand-made chains of front nodes.

#include "propagation/FrontState.hpp"
#include "propagation/FrontWarnings.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace Rhegma;
using namespace Rhegma::propagation;

namespace
{

/// A front of nodes with these names.
CrackFront<3> frontOf(const std::vector<int>& names)
{
  CrackFront<3> front;
  for (const int name : names)
  {
    FrontNode<3> node;
    node.name = name;
    front.nodes.push_back(node);
  }
  return front;
}

/// Lets the history of a node run for a number of increments of 1 mm in 10 us each.
void run(FrontNodeState& node, int increments)
{
  const AdvanceRule rule{Toughness::parse("100*(1 + v/100)"), 100.0, 100.0, 0.0};
  for (double time = 0.0; node.history.increments() < increments;)
    node.history.advance(rule, time += 1e-6, 200.0, 1e-3, 1000.0);
}

} // namespace

/// In 2D a front has one node from the beginning, in 3D none until its pieces are known.
TEST(FrontNodes, ThereIsOneIn2D)
{
  EXPECT_EQ(CrackFront<2>().nodes.size(), 1u);
  EXPECT_TRUE(CrackFront<3>().nodes.empty());
}

/// A front advances where any of its nodes does, has stopped where all have, and is as fast as its fastest
/// node that has not.
TEST(FrontNodes, DecideForTheirFront)
{
  CrackFront<3> front = frontOf({0, 1, 2});
  EXPECT_FALSE(front.advances());
  EXPECT_FALSE(front.stopped());
  front.nodes[1].advances = true;
  EXPECT_TRUE(front.advances());
  front.nodes[0].speed = 300.0;
  front.nodes[2].speed = 200.0;
  EXPECT_EQ(front.speed(), 300.0);
  front.nodes[0].stopped = true;
  EXPECT_EQ(front.speed(), 200.0);
  front.nodes[1].stopped = front.nodes[2].stopped = true;
  EXPECT_TRUE(front.stopped());
  EXPECT_EQ(front.speed(), 0.0);
}

/// A node that has landed at a surface is not one that the cells have stopped, and of a front that has ended
/// none is.
TEST(FrontNodes, AreStoppedOnlyWhereTheyHaveNotLanded)
{
  CrackFront<3> front = frontOf({0, 1, 2, 3});
  EXPECT_EQ(front.numStopped(), 0);
  for (int k = 0; k < 3; ++k)
    front.nodes[k].stopped = true;
  front.nodes[0].landed = true;
  EXPECT_EQ(front.numStopped(), 2);
  front.ended = true;
  EXPECT_EQ(front.numStopped(), 0);
}

/// A new node has the past of the one that it came from; that of a node that is no more is forgotten.
TEST(FrontState, NewNodesInheritTheirPast)
{
  FrontState<3> state;
  CrackFront<3> front = frontOf({0, 1});
  state.matchNodes(front);
  run(state.nodes.at(0), 3);
  run(state.nodes.at(1), 5);
  front.nodes[0].name = 2;
  front.nodes[0].from = 0;
  state.matchNodes(front);
  ASSERT_EQ(state.nodes.size(), 2u);
  EXPECT_EQ(state.nodes.at(2).history.increments(), 3);
  EXPECT_EQ(state.nodes.at(1).history.increments(), 5);
  EXPECT_EQ(state.nodes.count(0), 0u);
}

/// What G had reached before the start time is that of the front, also once the node is gone.
TEST(FrontState, RemembersWhatFormerNodesReached)
{
  FrontState<3> state;
  state.matchNodes(frontOf({0, 1}));
  const AdvanceRule rule{Toughness::parse("10"), 10.0, 10.0, 2.0};
  state.nodes.at(0).history.recordAtRest(rule, 1.0, 17.0);
  state.nodes.at(1).history.recordAtRest(rule, 1.0, 12.0);
  EXPECT_EQ(state.early(), 1.7);
  state.matchNodes(frontOf({1}));
  EXPECT_EQ(state.early(), 1.7);
}

/// The first advance is that of the node with the largest G, wherever it is along the front.
TEST(FrontState, StartsWithTheLargestRelease)
{
  FirstAdvance first;
  for (const FirstAdvance& node :
       {FirstAdvance{1.1, 2.0, 3.0, 0.1, false}, {1.6, 4.0, 5.0, 0.2, true}, {1.3, 6.0, 7.0, 0.3, false}})
    first.include(node);
  EXPECT_EQ(first.release, 1.6);
  EXPECT_EQ(first.modeI, 4.0);
  EXPECT_EQ(first.modeIII, 0.2);
  EXPECT_TRUE(first.held);
}

/// A front is held by the start time where G had reached the toughness before it and does not fall below it
/// until then, by samples and straight lines between them.
TEST(FrontHistory, KnowsWhetherItWasHeld)
{
  const AdvanceRule rule{Toughness::parse("10"), 10.0, 10.0, 2.0};
  const auto held = [&](double timeBefore, double before, double time, double now)
  {
    FrontHistory history;
    history.recordAtRest(rule, timeBefore, before);
    return history.wasHeld(rule, time, now);
  };
  EXPECT_TRUE(held(1.9, 11.0, 2.1, 13.0));
  EXPECT_TRUE(held(1.9, 14.0, 2.1, 11.0)) << "it falls";
  EXPECT_TRUE(held(1.9, 9.0, 2.1, 13.0)) << "11 at the start time";
  EXPECT_FALSE(held(1.9, 7.0, 2.1, 11.0)) << "9 at the start time";
  EXPECT_FALSE(held(2.0, 9.0, 2.1, 11.0)) << "below the toughness once it might advance";
  FrontHistory touched; // before, by another load
  touched.recordAtRest(rule, 1.0, 15.0);
  touched.recordAtRest(rule, 2.5, 3.0);
  EXPECT_FALSE(touched.wasHeld(rule, 5.0, 12.0));
}

/// The settled speed of a front that has no node left is that of the nodes that it had last.
TEST(FrontState, KeepsItsSettledSpeedWhenItHasEnded)
{
  FrontState<3> state;
  const CrackFront<3> alive = frontOf({0}), over = frontOf({});
  state.matchNodes(alive);
  run(state.nodes.at(0), 20);
  const double speed = state.settledSpeed();
  EXPECT_NEAR(speed, 100.0, 1.0); // Gc(100 m/s) is 200 J/m2
  EXPECT_TRUE(state.running(alive));
  state.matchNodes(over);
  EXPECT_EQ(state.settledSpeed(), speed);
  EXPECT_FALSE(state.running(over));
}

/// Increments of all nodes count, from the earliest to the latest.
TEST(FrontState, CountsTheIncrementsOfAllNodes)
{
  FrontState<3> state;
  state.matchNodes(frontOf({0, 1}));
  run(state.nodes.at(0), 3);
  run(state.nodes.at(1), 5);
  state.count(state.nodes.at(1).history, 5);
  state.count(state.nodes.at(0).history, 3);
  EXPECT_EQ(state.increments, 8);
  EXPECT_EQ(state.firstTime, state.nodes.at(0).history.firstTime());
  EXPECT_EQ(state.lastTime, state.nodes.at(1).history.lastTime());
}

/// Of the contours of growth in equilibrium the largest difference of all samples is kept, on either side.
TEST(FrontState, KeepsTheLargestDifferenceOfContours)
{
  ContourDifference contours;
  contours.include(50.0, 0.0, 0.5); // without a release there is nothing to compare with
  EXPECT_EQ(contours.release, 0.0);
  contours.include(95.0, 100.0, 1.0);
  contours.include(313.0, 100.0, 2.0);
  contours.include(20.0, 100.0, 3.0);
  contours.include(101.0, 101.0, 4.0);
  EXPECT_DOUBLE_EQ(contours.ratio, 3.13);
  EXPECT_EQ(contours.release, 100.0);
  EXPECT_EQ(contours.time, 2.0);
  nlohmann::json summary = {{"warnings", nlohmann::json::array()}};
  compareContours("crack A, front 0", contours, summary);
  ASSERT_EQ(summary["warnings"].size(), 1u);
  EXPECT_NE(summary["warnings"][0].get<std::string>().find("313 %"), std::string::npos) << summary;
  contours = {};
  contours.include(95.0, 100.0, 1.0);
  compareContours("crack A, front 0", contours, summary);
  EXPECT_EQ(summary["warnings"].size(), 1u);
}
