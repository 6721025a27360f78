/// Damping that leaves no motion, or never brings a body to rest.

#include "damping/JudgeDamping.hpp"
#include "src/plausibility/Warnings.hpp"

namespace Rhegma
{
namespace Test
{
namespace
{

/// A plate that is pulled for 0.1 s. \param rate [1/s]
Teuchos::RCP<Teuchos::ParameterList> dampedPlate(double rate, bool stops)
{
  const auto scene = freePlate();
  scene->sublist("Time").set("Final Time", 0.1);
  hold(*scene, "Grip", pair(-0.1, -0.1), pair(0.05, 1.1));
  pull(*scene, 1e6);
  scene->sublist("Damping").set("Mass Rate", rate);
  scene->sublist("Damping").set("Stop When Settled", stops);
  return scene;
}

const std::string never = "so the run ends before it has settled";

} // namespace

/// exp(-4 / s 0.1 s / 2) = 0.8187, and 0.01 % take 2 ln(1e4) / 0.1 s.
TEST(Settling, ThatIsNeverReachedIsSaid)
{
  const Warnings said = warningsOf(dampedPlate(4.0, true));
  EXPECT_TRUE(say(
      said,
      "Damping > Mass Rate is 4 1/s: when damping ends, 81.87 % of an oscillation is left (after 100 ms)"));
  EXPECT_TRUE(say(said, never));
  EXPECT_TRUE(say(said, "write at least 184.2 1/s"));
}

TEST(Settling, IsNotSaidOfARunThatGoesOnOrIsDampedWell)
{
  EXPECT_FALSE(say(warningsOf(dampedPlate(4.0, false)), never));
  EXPECT_FALSE(say(warningsOf(dampedPlate(2000.0, true)), never));
  const auto viscous = dampedPlate(0.0, true);
  viscous->sublist("Damping").set("Bulk Viscosity", 1e6); // 1e6 / M w^2 / 2 = 630 / s
  EXPECT_FALSE(say(warningsOf(viscous), never));
  const auto ended = dampedPlate(2000.0, true);
  ended->sublist("Damping").set("End Time", 1e-4);
  EXPECT_TRUE(say(warningsOf(ended), never));
}

/// With ten times critical damping the slow rate is w (10 - sqrt(99)) = 0.0501 w. Its wave speed and length
/// are those of the plate.
TEST(Settling, ThatCreepsIsSaid)
{
  EXPECT_DOUBLE_EQ(damping::slowRate(3.0, 7.0), 1.5);
  EXPECT_DOUBLE_EQ(damping::slowRate(14.0, 7.0), 7.0);
  EXPECT_NEAR(damping::slowRate(140.0, 7.0), 7.0 * (10.0 - std::sqrt(99.0)), 1e-12);
  EXPECT_NEAR(damping::slowRate(1e12, 7.0), 49e-12, 1e-20); // w^2 / r
  const Warnings mild = warningsOf(dampedPlate(2000.0, true)), strong = warningsOf(dampedPlate(2e7, true));
  EXPECT_FALSE(say(mild, "creeps to equilibrium"));
  EXPECT_TRUE(say(strong, "creeps to equilibrium"));
}

/// Arms of 50 mm thickness and 500 mm length: w = 3.52 / sqrt(12) c h / a^2 = 1054 / s, 6 % of the wave along
/// the plate (16,300 / s). At critical damping of the wave, 1 - exp(-w^2 / r 0.01 s) is hardly half of the
/// motion.
TEST(Settling, OfArmsNextToACrackIsThatOfTheirBending)
{
  for (const bool cracked : {true, false})
  {
    const auto scene = steelPlate(-0.4, 1.4, 0.025, pair(0.0, 0.0), pair(1.0, 0.1));
    scene->sublist("Time").set("Final Time", 0.01);
    pull(*scene, 1e6).set("To", pair(1.0, 0.1));
    if (cracked)
      scene->sublist("Cracks").sublist("Notch").set("Points",
                                                    Reals(std::vector<double>{-0.01, 0.05, 0.5, 0.05}));
    scene->sublist("Damping").set("Mass Rate", 2.0 * 16300.0).set("Stop When Settled", true);
    const Warnings said = warningsOf(scene);
    EXPECT_EQ(
        say(said, "times the critical damping of the bending of arms of Plate, 50 mm thick and 500 mm long"),
        cracked);
    EXPECT_EQ(say(said, "write about 2109 1/s"), cracked);
  }
}

/// Five samples are compared, which take four intervals.
TEST(Settling, InSamplesThatAreNotTakenIsSaid)
{
  for (const double interval : {1.0, 0.026, 0.024, 1e-3})
    for (const bool stops : {true, false})
    {
      const auto scene = dampedPlate(2000.0, stops);
      scene->sublist("Output").set("History Interval", interval);
      const Warnings said = warningsOf(scene);
      EXPECT_EQ(say(said, "Output > History Interval is "), stops && interval > 0.025) << interval;
      EXPECT_EQ(say(said, "there are 0 samples: Damping > Stop When Settled compares the last 5"),
                stops && interval == 1.0);
    }
}

TEST(Damping, ThatHoldsABodyIsSaid)
{
  EXPECT_TRUE(say(warningsOf(dampedPlate(1e9, false)), "so it hardly moves"));
  EXPECT_TRUE(say(warningsOf(dampedPlate(1e9, false)), "times 1 / (stable time step)"));
}

} // namespace Test
} // namespace Rhegma
