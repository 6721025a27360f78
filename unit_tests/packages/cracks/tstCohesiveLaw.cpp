/// The laws of springs and of cohesive tractions, with numbers that can be checked by hand.

#include "cracks/CohesiveLaw.hpp"

#include <gtest/gtest.h>

namespace Rhegma::cracks
{

namespace
{

/// From 4 N at 1 m to zero at 4 m: a triangle of 6 J.
const CohesiveLaw law{4.0, 3.0, 1.0};

/// Work of the traction between two openings, by trapezoids; exact where it is linear [J].
double work(double from, double to, double largest)
{
  double sum = 0.0;
  for (int k = 0; k < 100; ++k)
  {
    const double a = from + (to - from) * k / 100, b = from + (to - from) * (k + 1) / 100;
    sum += 0.5 * (law.traction(a, largest) + law.traction(b, largest)) * (b - a);
  }
  return sum;
}

} // namespace

TEST(CohesiveLaw, LoadingToZeroDissipatesTheTriangle)
{
  EXPECT_DOUBLE_EQ(law.traction(1.0, 1.0), 4.0);
  EXPECT_DOUBLE_EQ(law.traction(2.5, 2.5), 2.0);
  EXPECT_DOUBLE_EQ(law.traction(4.0, 4.0), 0.0);
  EXPECT_DOUBLE_EQ(law.traction(9.0, 9.0), 0.0);
  EXPECT_FALSE(law.isOpen(3.9));
  EXPECT_TRUE(law.isOpen(4.0));
  EXPECT_DOUBLE_EQ(law.energy(), 6.0);
  EXPECT_NEAR(work(1.0, 4.0, 1.0), 6.0, 1e-12);
  EXPECT_DOUBLE_EQ(law.pendingEnergy(1.0, 1.0), 6.0);
  EXPECT_DOUBLE_EQ(law.pendingEnergy(4.0, 16.0), 0.0);
}

/// Opened to 2.5 m, where 2 N act, the node unloads with 0.8 N/m and reloads with the same.
TEST(CohesiveLaw, UnloadsAndReloadsAlongTheSecant)
{
  EXPECT_DOUBLE_EQ(law.secant(2.5), 0.8);
  EXPECT_DOUBLE_EQ(law.traction(1.25, 2.5), 1.0);
  EXPECT_DOUBLE_EQ(law.traction(0.0, 2.5), 0.0);
  EXPECT_DOUBLE_EQ(law.traction(2.5, 2.5), 2.0);
  EXPECT_NEAR(work(2.5, 1.25, 2.5), -1.875, 1e-12);
  EXPECT_NEAR(work(1.25, 2.5, 2.5), 1.875, 1e-12);
}

/// At any opening and after any unloading the work so far and the pending energy are the 6 J.
TEST(CohesiveLaw, WorkAndPendingEnergyAddUpToTheEnergy)
{
  EXPECT_DOUBLE_EQ(law.pendingEnergy(2.5, 2.5 * 2.5), 1.5);
  EXPECT_DOUBLE_EQ(law.pendingEnergy(2.5, 1.25 * 1.25), 1.5 + 1.875);
  for (const double largest : {1.0, 1.7, 2.5, 3.9})
    for (const double fraction : {1.0, 0.6, 0.0})
    {
      const double now = fraction * largest;
      EXPECT_NEAR(work(1.0, largest, 1.0) + work(largest, now, largest) +
                      law.pendingEnergy(largest, now * now),
                  6.0, 1e-12);
    }
}

/// Two nodes held by 3 and 1 N divide 19 J by their forces, both within w = 10 m.
TEST(CohesiveLaw, NodesDivideAnEnergyByTheirForces)
{
  const double range = releaseRange(19.0, 4.0);
  EXPECT_DOUBLE_EQ(range, 10.0);
  const double fraction = springs::initialFraction, stiffness = 2.0;
  const CohesiveLaw first = releaseLaw(fraction * 3.0, range, fraction, stiffness),
                    second = releaseLaw(fraction * 1.0, range, fraction, stiffness);
  EXPECT_DOUBLE_EQ(first.energy(), 14.25);
  EXPECT_DOUBLE_EQ(second.energy(), 4.75);
  EXPECT_DOUBLE_EQ(first.onset, 1.425);
}

/// Stiffness times opening at all positions of a front in its cell lie on one line, if openings are in
/// proportion to xi.
TEST(CohesiveLaw, FrontSpringsFollowALine)
{
  const FrontLaw front{true};
  const double slope = frontCellSlope<2>(10.0, 2.0, 0.0, 1.0, front), ahead = splitAhead<2>(1.0, 0.0, front),
               open = 5.0;
  EXPECT_DOUBLE_EQ(slope, frontCell::limited::stiffness * 20.0);
  for (const double behind : {0.0, 0.2, 0.5, 0.7})
  {
    const double opening = open * (behind + ahead) / frontCell::limited::range;
    EXPECT_NEAR(frontSpringStiffness<2>(10.0, 2.0, behind, 0.0, 1.0, front) * opening,
                slope * (open - opening), 1e-12 * slope * open);
  }
  EXPECT_EQ(frontCellSlope<2>(10.0, 2.0, 0.0, 0.8, front), 0.0); // at an angle, limited
}

/// Where the fields would pass w within a step the node starts with less force and dissipates the same.
TEST(CohesiveLaw, ShortRangesStartWithLessForce)
{
  EXPECT_DOUBLE_EQ(startingFraction(10.0, 1.0), springs::initialFraction);
  const double holding = 5.0, range = 0.16 / springs::initialFraction; // phi (1 - phi) = 0.16 for 1 m apart
  const double fraction = startingFraction(range, 1.0);
  EXPECT_DOUBLE_EQ(fraction, 0.2);
  const CohesiveLaw less = releaseLaw(fraction * holding, range, fraction, 1.0);
  EXPECT_DOUBLE_EQ(less.strength, 1.0);
  EXPECT_DOUBLE_EQ(less.range, 0.8); // (1 - phi) of 1 m
  EXPECT_DOUBLE_EQ(less.energy(), 0.5 * springs::initialFraction * holding * range);
}

/// In 3D a front spring is half of its value at 0.45 cells behind the front, is divided between the nodes
/// above and below the crack, and ends within a cell.
TEST(CohesiveLaw, FrontSpringsEndACellBehindTheFront)
{
  EXPECT_DOUBLE_EQ(frontSpringStiffness<3>(10.0, 2.0, 0.45, 0.0, 1.0, FrontLaw{}), 2.0); // 0.1 E' b
  EXPECT_DOUBLE_EQ(frontSpringStiffness<3>(10.0, 2.0, 0.45, 0.25, 1.0, FrontLaw{}), 1.5);
  EXPECT_DOUBLE_EQ(frontSpringStiffness<3>(10.0, 2.0, 0.45, 0.75, 1.0, FrontLaw{}), 0.5);
  EXPECT_NEAR(frontSpringStiffness<3>(10.0, 2.0, 0.0, 0.0, 1.0, FrontLaw{}), 38.0,
              1e-12); // (1 - 0.05) / 0.05 times that
  EXPECT_EQ(frontSpringStiffness<3>(10.0, 2.0, 0.96, 0.0, 1.0, FrontLaw{}), 0.0);
  EXPECT_EQ(frontSpringStiffness<3>(10.0, 2.0, 0.45, 1.0, 1.0, FrontLaw{}), 0.0);
}

/// In 2D springs end where the next node opens, so that the crack of the cells grows continuously: nodes of a
/// row are a cell apart. At an angle to the cells 2D has the law of 3D.
TEST(CohesiveLaw, FrontSpringsHandOverFromNodeToNode)
{
  const double ahead = splitAhead<2>(1.0, 0.0, FrontLaw{true});
  EXPECT_GT(ahead, 0.1);
  EXPECT_LT(ahead, 0.3);
  EXPECT_GT(splitAhead<2>(1.0, 0.5, FrontLaw{true}), ahead);
  EXPECT_DOUBLE_EQ(splitAhead<2>(0.8, 0.0, FrontLaw{true}), springs::splitAheadInclined);
  const double soft = frontSpringStiffness<2>(10.0, 2.0, 0.9 - ahead, 0.0, 1.0, FrontLaw{true});
  EXPECT_GT(soft, 0.0);
  EXPECT_LT(soft, 1.0);
  EXPECT_GT(frontSpringStiffness<2>(10.0, 2.0, -ahead, 0.0, 1.0, FrontLaw{true}), 50.0);
  EXPECT_EQ(frontSpringStiffness<2>(10.0, 2.0, 1.05 - ahead, 0.0, 1.0, FrontLaw{true}), 0.0);
  EXPECT_DOUBLE_EQ(openingFraction(3.0, 3.0), 1.0);
  EXPECT_DOUBLE_EQ(openingFraction(7.0, 1.0), 0.5);
  EXPECT_DOUBLE_EQ(splitAhead<2>(1.0, 0.0, FrontLaw{}),
                   -springs::splitBehindAligned); // where faces are loaded
  EXPECT_EQ(openingFraction(1.0, 0.0), 0.0);
}

/// Where no step limits springs the law of the front's cell holds at every angle and in 3D, a node that just
/// opens is as good as closed, and nothing changes suddenly where the crack passes the next node.
TEST(CohesiveLaw, WithoutLimitsOneLawHoldsEverywhere)
{
  const FrontLaw law{true, true};
  const double ahead = splitAhead<2>(0.8, 0.0, law);
  EXPECT_DOUBLE_EQ(ahead, (frontCell::unlimited::lag + 0.2 * frontCell::unlimited::lagTurned) / 0.8);
  EXPECT_GT(frontSpringStiffness<2>(1.0, 1.0, -ahead, 0.0, 0.8, law), 50.0);
  for (const double behind : {-0.2, 0.0, 0.5})
  {
    const double stiffness = frontSpringStiffness<2>(1.0, 1.0, behind, 0.5, 0.8, law);
    EXPECT_GT(stiffness, 0.0);
    for (const double away : {0.99, 1.01, 1.5})
      EXPECT_EQ(frontSpringStiffness<2>(1.0, 1.0, behind, away, 0.8, law), stiffness);
    EXPECT_EQ(frontSpringStiffness<3>(1.0, 1.0, behind, 0.5, 0.8, law), stiffness);
    const double more = frontCell::unlimited::onCrack * stiffness;
    EXPECT_DOUBLE_EQ(frontSpringStiffness<2>(1.0, 1.0, behind, 0.0, 0.8, law), stiffness + more);
    EXPECT_DOUBLE_EQ(frontSpringStiffness<2>(1.0, 1.0, behind, 0.25, 0.8, law), stiffness + 0.5 * more);
  }
}

/// A spring of 8 N/m stretched by 0.5 m stores 1 J and dissipates another one as it softens; by a slope of 2
/// N/m another 4 J, of which new faces under half of G dissipate half.
TEST(CohesiveLaw, SpringsSoftenOverAnotherStretch)
{
  const CohesiveLaw softening = softeningLaw(8.0, 0.5, 0.0, 1.0);
  EXPECT_DOUBLE_EQ(softening.traction(0.5, 0.5), 4.0);
  EXPECT_DOUBLE_EQ(softening.traction(0.75, 0.75), 2.0);
  EXPECT_TRUE(softening.isOpen(1.0));
  EXPECT_DOUBLE_EQ(softening.energy(), 1.0);
  EXPECT_DOUBLE_EQ(softenedEnergy(softening), 2.0);
  EXPECT_DOUBLE_EQ(softeningLaw(8.0, 0.5, 2.0, 1.0).energy(), 4.0);
  EXPECT_DOUBLE_EQ(softeningLaw(8.0, 0.5, 2.0, 0.5).energy(), 2.0);
}

} // namespace Rhegma::cracks
