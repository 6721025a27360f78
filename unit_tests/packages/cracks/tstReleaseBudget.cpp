/// The energy of new faces at one front, in round numbers.

#include "cracks/SpringConstants.hpp"
#include "state/ReleaseBudget.hpp"

#include <gtest/gtest.h>

namespace Rhegma
{

namespace
{

using namespace cracks::springs;

/// What is released without being required by any face: zero.
double created(const ReleaseBudget& budget)
{
  return budget.released + budget.pending - budget.required - budget.advected - budget.carriedOver -
         budget.overDissipated;
}

double releaseAll(ReleaseBudget& budget, double ofAdvection)
{
  return budget.releaseAll(ofAdvection, carriedOverFraction, deductedFraction);
}

} // namespace

TEST(ReleaseBudget, AllThatIsRequiredIsReleasedOnce)
{
  ReleaseBudget budget;
  budget.require(3.0);
  budget.require(5.0);
  EXPECT_EQ(budget.pending, 8.0);
  EXPECT_EQ(releaseAll(budget, 100.0), 8.0);
  EXPECT_EQ(budget.pending, 0.0);
  EXPECT_EQ(budget.released, 8.0);
  EXPECT_EQ(releaseAll(budget, 0.0), 0.0);
  EXPECT_EQ(budget.released, budget.required);
  EXPECT_EQ(created(budget), 0.0);
}

/// Softened springs dissipate 10 J; nodes with 16 J each give up a quarter until these are deducted.
TEST(ReleaseBudget, EnergyOfSoftenedSpringsIsCarriedOver)
{
  ReleaseBudget budget;
  budget.carryOver(10.0);
  for (const double ofNodes : {12.0, 12.0, 14.0, 16.0})
  {
    budget.require(16.0);
    EXPECT_EQ(releaseAll(budget, 0.0), ofNodes);
    EXPECT_EQ(created(budget), 0.0);
  }
  EXPECT_EQ(budget.carriedOver, 0.0);
  EXPECT_EQ(budget.released, 64.0);
}

/// 20 J too much; nodes with 16 J keep a tenth of them at least, until these are deducted.
TEST(ReleaseBudget, OverDissipationIsCarriedOver)
{
  ReleaseBudget budget;
  budget.overDissipate(20.0);
  budget.require(16.0);
  EXPECT_NEAR(releaseAll(budget, 0.0), 1.6, 1e-14);
  EXPECT_NEAR(budget.overDissipated, 5.6, 1e-14);
  budget.require(16.0);
  EXPECT_NEAR(releaseAll(budget, 0.0), 10.4, 1e-14);
  EXPECT_EQ(budget.overDissipated, 0.0);
  EXPECT_NEAR(budget.released, budget.required, 1e-14);
}

/// However much is to be deducted, a node keeps (1 - 1/4) (1 - 9/10) of its energy.
TEST(ReleaseBudget, NodesKeepAPartOfTheirEnergy)
{
  ReleaseBudget budget;
  budget.carryOver(1e6);
  budget.overDissipate(1e6);
  budget.require(16.0);
  EXPECT_NEAR(releaseAll(budget, 0.0), 0.075 * 16.0, 1e-12);
  EXPECT_NEAR(created(budget), 0.0, 1e-9);
}

TEST(ReleaseBudget, ReturnedEnergyIsPendingAgain)
{
  ReleaseBudget budget;
  budget.require(8.0);
  releaseAll(budget, 0.0);
  budget.returnPending(3.0);
  EXPECT_EQ(budget.pending, 3.0);
  EXPECT_EQ(budget.released, 5.0);
  EXPECT_EQ(created(budget), 0.0);
  EXPECT_EQ(releaseAll(budget, 0.0), 3.0);
  EXPECT_EQ(budget.released, budget.required);
}

/// Nodes that the front reaches as material moves have the energy of the last faces, which no face requires.
TEST(ReleaseBudget, AdvectedNodesAreCountedApart)
{
  ReleaseBudget budget;
  EXPECT_EQ(releaseAll(budget, 4.0), 4.0);
  EXPECT_EQ(budget.advected, 4.0);
  EXPECT_EQ(budget.required, 0.0);
  EXPECT_EQ(created(budget), 0.0);
}

/// A front with 10 J pending and a row of 8 J: nodes of 10 J get just that, those of 8 J a quarter more,
/// those of 30 J no less than half.
TEST(ReleaseBudget, NodesByAreaFollowThePendingEnergy)
{
  ReleaseBudget budget;
  budget.require(10.0);
  const auto fraction = [&](double wanted, double row)
  { return budget.fractionOfArea(wanted, row, smallestByArea, largestByArea); };
  EXPECT_EQ(fraction(10.0, 8.0), 1.0);
  EXPECT_EQ(fraction(8.0, 8.0), 1.25);
  EXPECT_EQ(fraction(2.0, 8.0), largestByArea);
  EXPECT_EQ(fraction(30.0, 8.0), smallestByArea);
  EXPECT_EQ(fraction(8.0, 0.0), 1.25); // no more nodes follow
  budget.release(12.0);
  EXPECT_EQ(budget.pending, -2.0);
  EXPECT_EQ(created(budget), 0.0);
}

/// By area, what springs and nodes dissipate beyond their energy is deducted from what is pending at once.
TEST(ReleaseBudget, DeductionsByAreaAreNotDeferred)
{
  ReleaseBudget budget{true};
  budget.require(10.0);
  budget.carryOver(3.0);
  budget.overDissipate(4.0);
  EXPECT_EQ(budget.pending, 3.0);
  EXPECT_EQ(budget.released, 7.0);
  EXPECT_EQ(budget.carriedOver, 0.0);
  EXPECT_EQ(budget.overDissipated, 0.0);
  EXPECT_EQ(created(budget), 0.0);
}

} // namespace Rhegma
