/// Detection of unstable runs by the energy balance.

#include "step/EnergyWatch.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace Rhegma
{
namespace Test
{

namespace
{

/// Energy balance of bodies to which 2 J were given and that store this energy [J].
EnergyBalance holding(double energy)
{
  EnergyBalance balance;
  balance.start = 0.5;
  balance.externalWork = 1.5;
  balance.strain = energy;
  return balance;
}

constexpr long manySteps = 1000;

} // namespace

TEST(EnergyWatch, IsSilentWhereTheBalanceCloses)
{
  EnergyWatch watch;
  for (int k = 0; k < 100; ++k)
    watch.sample(holding(2.0 + (k % 2 == 0 ? 0.15 : -0.15)));
  EXPECT_EQ(watch.failure(), "");
  EXPECT_EQ(watch.warning(false, manySteps), "");
}

TEST(EnergyWatch, StopsARunThatCreatesEnergyAndNotForOneRoughSample)
{
  EnergyWatch watch;
  for (int k = 0; k < 2; ++k)
  {
    watch.sample(holding(30.0));
    EXPECT_EQ(watch.failure(), "");
  }
  watch.sample(holding(2.0));
  for (int k = 0; k < 2; ++k)
    watch.sample(holding(30.0));
  EXPECT_EQ(watch.failure(), "");
  watch.sample(holding(30.0));
  EXPECT_NE(watch.failure().find("energy of the bodies is 30 J, but at most 2 J was supplied"),
            std::string::npos)
      << watch.failure();
}

TEST(EnergyWatch, StopsWhereAnEnergyIsNoNumber)
{
  EnergyWatch watch;
  watch.sample(holding(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_NE(watch.failure().find("not finite"), std::string::npos);
  EXPECT_EQ(watch.failure().find("Sub-Cycling"), std::string::npos);
  EXPECT_NE(watch.failure(2).find("a smaller Time > CFL, fewer Sub-Cycling > Levels"), std::string::npos);
}

TEST(EnergyWatch, ReportsEnergyThatWasCreatedOrLost)
{
  EnergyWatch made;
  made.sample(holding(2.5));
  made.sample(holding(2.0));
  EXPECT_EQ(made.failure(), "");
  EXPECT_NE(made.warning(true, manySteps).find("gained 25 % more"), std::string::npos);
  EnergyWatch lost;
  lost.sample(holding(1.0));
  EXPECT_NE(lost.warning(false, manySteps).find("lost 50 %"), std::string::npos);
  EXPECT_EQ(lost.warning(true, manySteps), "") << "a fraction of PIC is meant to lose it";
}

TEST(EnergyWatch, IsSilentOnAFewSteps)
{
  EnergyWatch watch;
  watch.sample(holding(1.0));
  EXPECT_EQ(watch.warning(false, 3), "");
}

/// A single load step that does too little work: 0.5 + 1.5 J were given.
TEST(EnergyWatch, WarnsOfEquilibriaOfAnyNumberOfSteps)
{
  EnergyWatch open;
  open.sample(holding(2.5));
  const std::string warning = open.warningInEquilibrium({});
  EXPECT_NE(warning.find("open by 500 mJ, 25 % of"), std::string::npos) << warning;
  EXPECT_NE(warning.find("more Time > Load Steps"), std::string::npos);
  EnergyWatch closed;
  closed.sample(holding(2.5));
  closed.sample(holding(1.85));
  EXPECT_EQ(closed.warningInEquilibrium({}), "") << "the last state counts";
}

namespace
{

/// 100 J were supplied, 0.01 J were missing before growth, and new faces took 1 J.
EnergyWatch grown(double released)
{
  EnergyWatch watch;
  EnergyBalance balance;
  balance.externalWork = 100.0;
  balance.strain = 100.01;
  watch.sample(balance);
  balance.fracture = 1.0;
  balance.strain -= released;
  watch.sample(balance);
  return watch;
}

constexpr GrowthInEquilibrium givenLoads{true, false, false, false}, loadFactor{true, true, false, false};

bool contains(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

} // namespace

/// Of 1 J that new faces took 0.5 J were released, which is a wrong G under any loads; where 1.5 J were
/// released, only under a factor, since given loads may release more.
TEST(EnergyWatch, ComparesWhatNewFacesTookWithWhatWasReleased)
{
  const std::string half = grown(0.5).warningInEquilibrium(loadFactor);
  EXPECT_TRUE(contains(half, "took 1 J (toughness times new area), but bodies and loads released 500 mJ"))
      << half;
  EXPECT_TRUE(contains(half, "smaller increments (Propagation > Increment)"));
  EXPECT_EQ(grown(0.5).warningInEquilibrium(givenLoads), half);
  EXPECT_NE(grown(1.5).warningInEquilibrium(loadFactor), "");
  EXPECT_EQ(grown(1.5).warningInEquilibrium(givenLoads), "");
  EXPECT_EQ(grown(0.95).warningInEquilibrium(loadFactor), "");
  EXPECT_EQ(grown(0.5).warningInEquilibrium({}), "") << "half a percent of what was supplied";
  EXPECT_EQ(EnergyWatch().warningInEquilibrium(loadFactor), "");
}

/// A body that comes apart loses what it stores at once: 30 J here, which no G explains, nor load steps.
TEST(EnergyWatch, ComparesUpToWhereAFrontReachesASurface)
{
  EnergyWatch watch = grown(1.0);
  EnergyBalance balance;
  balance.externalWork = 100.0;
  balance.fracture = 2.0;
  balance.strain = 68.0;
  watch.sample(balance, true);
  const std::string apart = watch.warningInEquilibrium({true, true, true, false});
  EXPECT_TRUE(contains(apart, "open by -30 J, 30 %")) << apart;
  EXPECT_TRUE(contains(apart, "a front has reached a surface or another crack")) << apart;
  balance.strain = 97.0;
  watch.sample(balance, true);
  EXPECT_EQ(watch.warningInEquilibrium({true, true, true, false}), "");
}

/// Load steps of bodies that are not linear are open for another reason than G, as are those where growth
/// seems to have released less than nothing. With a load factor more load steps are more increments.
TEST(EnergyWatch, BlamesLoadStepsOfBodiesThatAreNotLinear)
{
  for (const std::string& warning : {grown(0.5).warningInEquilibrium({true, false, false, true}),
                                     grown(-0.5).warningInEquilibrium(givenLoads)})
  {
    EXPECT_FALSE(contains(warning, "released")) << warning;
    EXPECT_TRUE(contains(warning, "use more Time > Load Steps")) << warning;
  }
  const std::string factor = grown(0.5).warningInEquilibrium({true, true, false, true});
  EXPECT_FALSE(contains(factor, "use more Time > Load Steps")) << factor;
  EXPECT_TRUE(contains(factor, "use smaller increments")) << factor;
  EnergyWatch above;
  above.sample(holding(1.0));
  EXPECT_TRUE(contains(above.warningInEquilibrium(givenLoads), "above the toughness"));
}

/// 8 J at the start, of which loads took 3 J and gave 2 J back: never more than 8 J.
TEST(EnergyWatch, SuppliedIsTheMostAtASample)
{
  EnergyWatch watch;
  EnergyBalance balance;
  balance.start = balance.strain = 8.0;
  watch.sample(balance);
  for (const double work : {-3.0, -1.0})
  {
    balance.externalWork = work;
    balance.strain = 8.0 + work;
    watch.sample(balance);
  }
  EXPECT_DOUBLE_EQ(watch.supplied(), 8.0);
}

/// Heat does not hide what is open in an equilibrium; what thermal strain misses along its path is allowed.
TEST(EnergyWatch, JudgesAnEquilibriumByMechanicalEnergies)
{
  EnergyBalance heated;
  heated.heat = 66.0;
  heated.strain = 6e-4;
  heated.thermal = 66.0 - 3.6e-4; // open by 40 % of the strain energy
  EnergyWatch watch;
  watch.sampleOfEquilibrium(heated, false, 1e-5);
  EXPECT_TRUE(contains(watch.warningInEquilibrium({}), "40 % of the energy supplied"));
  EXPECT_EQ(watch.supplied(), heated.strain);
  EnergyWatch ofFreeBody;
  ofFreeBody.sampleOfEquilibrium(heated, false, 3e-4);
  EXPECT_EQ(ofFreeBody.warningInEquilibrium({}), "");
  EnergyWatch ofMotion;
  ofMotion.sample(heated);
  EXPECT_EQ(ofMotion.warningInEquilibrium({}), "");
}

/// Work that was done and recovered still counts for the comparison.
TEST(EnergyWatch, RemembersTheMostThatWasGiven)
{
  EnergyWatch watch;
  EnergyBalance balance;
  balance.externalWork = balance.kinetic = 100.0;
  watch.sample(balance);
  balance.externalWork = 0.0;
  balance.kinetic = 5.0;
  for (int k = 0; k < 5; ++k)
    watch.sample(balance);
  EXPECT_EQ(watch.failure(), "");
  EXPECT_EQ(watch.warning(false, manySteps), "");
}

} // namespace Test
} // namespace Rhegma
